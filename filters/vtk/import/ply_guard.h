// Validates a whole PLY file before VTK's reader gets it: that reader trusts counts and indices, reads past the end of
// short lines and splits long ones.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace boxprobe {

struct PlyCheck {
  std::optional<std::string> text;                  ///< to be read in place of the file; none: VTK can read the file
  std::vector<std::array<std::uint8_t, 4>> colors;  ///< of vertices, unless they are bytes: VTK casts other types
  std::vector<std::uint32_t> triangles;             ///< corners from "tristrips", which VTK does not read
};

/// Throws InputError ("m.ply:12: what is wrong; what to do") for files on which VTK's reader would crash, or which it
/// would misread. The text differs from the file where VTK 9.1 does not support what PLY allows:
/// - Lines ended by a carriage return alone end with a line feed.
/// - Comments above 4080 characters are blank.
/// - A text body ends with a line end.
/// - A text body has no lists except corners, because vtkPLY uses an uninitialized variable for others.
/// - The list "texcoord" of faces is removed (text) or renamed (binary). VTK exchanges points that share coordinates,
///   and recurses without end if 128 coordinates are outside 0..1. Without a texture they are not needed.
/// Time and memory are linear in the size of the file.
PlyCheck checkPly(const std::string& path);

}  // namespace boxprobe
