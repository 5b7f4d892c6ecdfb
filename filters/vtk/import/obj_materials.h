// Reads MTL files as they occur in practice: written by hand, moved without their pictures, with paths of another
// system.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace boxprobe {

struct ObjMaterials {
  std::string text;                             ///< the file without pictures, with every material that is used
  std::map<std::string, std::string> pictures;  ///< of map_Kd, by material: existing paths
  std::set<std::string> missing;                ///< materials whose picture does not exist
  std::vector<std::string> warnings;
};

/// `file` may be empty: no material file. `used`: the names of usemtl. Throws InputError with the line of a picture
/// outside the model's folder.
ObjMaterials readObjMaterials(const std::string& file, const std::string& modelPath,
                              const std::vector<std::string>& used);

/// The rest of a line after its key, as VTK can read it: one word, with "_" for each space and for an empty name.
std::string materialWord(const std::string& line);

/// The path of the file `name` beside `file`, with Windows separators converted if only that path exists.
std::string pathBeside(const std::string& file, std::string name);

}  // namespace boxprobe
