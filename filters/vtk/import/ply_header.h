// Reads the header of a PLY file strictly. Source: Turk, "The PLY Polygon File Format" (1994); the type names are those
// of vtkPLY.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace boxprobe {

/// Of the header, comments apart.
constexpr std::size_t kLongestPlyLine = 4080;

enum class PlyFormat { Text, LittleEndian, BigEndian };
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::size_t sizeInBytes(PlyType type);

/// A property of an element.
struct PlyField {
  std::string name;
  PlyType type = PlyType::Float32;
  bool isList = false;
  PlyType countType = PlyType::Uint8;  ///< of lists
};

struct PlyElementHead {
  std::string name;
  std::size_t count = 0;  ///< at most INT_MAX and the number of bytes in the file
  std::size_t line = 0;   ///< from 1
  std::vector<PlyField> fields;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::Text;
  std::vector<PlyElementHead> elements;
  std::vector<std::string> textures;  ///< of "comment TextureFile NAME", in the file's order
  std::size_t lines = 0;              ///< up to and including end_header
  std::size_t body = 0;               ///< offset of the first byte of the body
};

/// Throws InputError "PATH:LINE: reason"; line 0 omits the line.
[[noreturn]] void failPly(const std::string& path, std::size_t line, const std::string& reason);

/// Splits a line into words at spaces, tabs and carriage returns.
void splitPlyLine(std::string_view line, std::vector<std::string_view>& words);

/// Throws InputError with the line. The result has a "vertex" with numbers x, y and z; "face", if present, has a list
/// "vertex_indices" (also from "vertex_index"); every element has fields; and each field of a known name is a number or
/// a list, as it has to be.
PlyHeader readPlyHeader(const std::string& path, const std::string& bytes);

}  // namespace boxprobe
