// What is looked at in OBJ, STL and VTP files before VTK's readers get them: they believe indices and counts, and ask
// for the memory first. These look for those alone; reading is VTK's. Know no VTK.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

/// What an OBJ file refers to.
struct ObjNames {
  std::string materialFile;  ///< with its folder; empty: none is named
};
/// Throws InputError ("m.obj:12: ...") for indices beyond what is defined and for a material file that is missing or
/// lies outside the model's folder, or names pictures that do.
ObjNames checkObj(const std::string& path);

/// Throws InputError if the counts of the header cannot be in a file of this size.
void checkVtp(const std::string& path);
void checkStl(const std::string& path);

}  // namespace boxprobe
