// What is looked at in an OBJ file before VTK's importer gets it, which believes indices. Reading is VTK's. Knows no
// VTK.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <vector>

namespace boxprobe {

/// What an OBJ file refers to, and what VTK's reader does not read of it.
struct ObjNames {
  std::string materialFile;                          ///< with its folder; empty: none is named, or it does not exist
  std::vector<std::string> materials;                ///< of usemtl, each once, as materialWord() has them
  std::string text;                                  ///< to be read in place of the file; empty: VTK can read the file
  std::map<std::array<float, 3>, glm::vec3> colors;  ///< of vertices that have one, by position; sRGB, 0 to 1
  std::vector<std::string> warnings;
};
/// Throws InputError ("m.obj:12: ...") for indices beyond what is defined and for a material file that lies outside the
/// model's folder.
ObjNames checkObj(const std::string& path);

}  // namespace boxprobe
