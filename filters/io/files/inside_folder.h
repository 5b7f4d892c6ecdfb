// Models refer to files beside them: pictures, buffers, materials.
#pragma once

#include <string>

namespace boxprobe {

/// Is `path`, with links resolved, in the folder of the file `model` or below it? Neither needs to exist.
bool insideFolderOf(const std::string& path, const std::string& model);

}  // namespace boxprobe
