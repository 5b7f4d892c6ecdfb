// MTL files as they are found: written by hand, moved without their pictures, with paths of another system. Called by
// the OBJ reader. Knows no VTK.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace boxprobe {

struct ObjMaterials {
  std::string text;                             ///< the file without pictures, with every material that is used
  std::map<std::string, std::string> pictures;  ///< of map_Kd, by material: paths that exist
  std::set<std::string> missing;                ///< materials whose picture does not exist
  std::vector<std::string> warnings;
};

/// `file` may be empty: no material file. `used` are the names of usemtl. Throws InputError naming the line of a
/// picture that lies outside of the model's folder.
ObjMaterials readObjMaterials(const std::string& file, const std::string& modelPath,
                              const std::vector<std::string>& used);

/// The rest of a line behind its key as VTK can read it: one word, "_" for each space and for no name at all.
std::string materialWord(const std::string& line);

/// The file `name` beside `file`, its separators those of Windows where only that exists.
std::string pathBeside(const std::string& file, std::string name);

}  // namespace boxprobe
