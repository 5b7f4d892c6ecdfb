// Models name files beside them: pictures, buffers, materials. Called by the readers of models.
#pragma once

#include <string>

namespace boxprobe {

/// Does `path`, links followed, lie in the folder of the file `model` or below it? Neither needs to exist.
bool insideFolderOf(const std::string& path, const std::string& model);

}  // namespace boxprobe
