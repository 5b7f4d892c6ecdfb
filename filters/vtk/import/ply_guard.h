// Checks a whole PLY file before VTK's reader gets it. That reader believes counts and indices, reads past the end of
// short lines and splits long ones. Called by the model reader. Knows no VTK.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace boxprobe {

struct PlyCheck {
  std::optional<std::string> text;                  ///< to be read in place of the file; none: VTK can read the file
  std::vector<std::array<std::uint8_t, 4>> colors;  ///< of vertices, where they are not in bytes: VTK casts those
  std::vector<std::uint32_t> triangles;             ///< corners out of "tristrips", which VTK does not read
};

/// Throws InputError ("m.ply:12: what is wrong; what to do") for files that VTK's reader would crash on or misread.
/// The text differs from the file where VTK 9.1 does not take what PLY allows:
/// - Lines that a carriage return alone ends, end with a line feed.
/// - Comments above 4080 characters are blank.
/// - A text body ends with a line end.
/// - A text body has no lists but the corners, because vtkPLY uses a variable that it never set for the others.
/// - The list "texcoord" of faces is gone (text) or renamed (binary). VTK exchanges points that share coordinates and
///   recurses without end if 128 coordinates lie outside 0..1. Without a texture nothing needs them.
/// Time and memory are linear in the size of the file.
PlyCheck checkPly(const std::string& path);

}  // namespace boxprobe
