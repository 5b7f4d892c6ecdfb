// Checks a whole PLY file before VTK's reader gets it. That reader believes counts and indices, reads past the end of
// short lines and splits long ones. Called by the model reader. Knows no VTK.
#pragma once

#include <optional>
#include <string>

namespace boxprobe {

/// Throws InputError ("m.ply:12: what is wrong; what to do") for files that VTK's reader would crash on or misread.
/// Returns the text that VTK must read in place of the file, or nothing if it can read the file itself. The text
/// differs from the file where VTK 9.1 does not take what PLY allows:
/// - Comments above 4080 characters are blank.
/// - A text body ends with a line end.
/// - A text body has no lists but the corners, because vtkPLY uses a variable that it never set for the others.
/// - The list "texcoord" of faces is gone (text) or renamed (binary). VTK exchanges points that share coordinates and
///   recurses without end if 128 coordinates lie outside 0..1. Without a texture nothing needs them.
/// Time and memory are linear in the size of the file.
std::optional<std::string> checkPly(const std::string& path);

}  // namespace boxprobe
