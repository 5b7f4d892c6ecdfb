// Validates an OBJ file before VTK's importer, which does not check indices, reads it.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <vector>

namespace boxprobe {

/// The files and materials that an OBJ file refers to, and data that VTK's reader ignores.
struct ObjNames {
  std::string materialFile;                          ///< with its folder; empty: not given, or it does not exist
  std::vector<std::string> materials;                ///< of usemtl, without duplicates, as from materialWord()
  std::string text;                                  ///< to be read in place of the file; empty: VTK can read the file
  std::map<std::array<float, 3>, glm::vec3> colors;  ///< of coloured vertices, by position; sRGB, 0 to 1
  std::vector<std::string> warnings;
};
/// Throws InputError ("m.obj:12: ...") for indices out of range, and for a material file outside the model's folder.
ObjNames checkObj(const std::string& path);

}  // namespace boxprobe
