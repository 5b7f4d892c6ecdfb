// Finds the files that a model names: written on other systems, moved, or spelt in other letters.
#pragma once

#include <string>

namespace boxprobe {

struct FileBeside {
  std::string path;      ///< of an existing file in the model's folder or below it; empty: none
  bool outside = false;  ///< the name leads out of that folder
};

/// `name` beside the file `from`: as it is written; with separators of Windows; with letters in another case; and, of a
/// path that leads nowhere, its last part beside `from` or beside the model. Never a file outside the model's folder.
FileBeside fileBeside(const std::string& from, const std::string& name, const std::string& model);

}  // namespace boxprobe
