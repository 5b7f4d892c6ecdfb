// Reads the header of a PLY file strictly: VTK 9.1's reader does not check for missing words, types and counts. Source:
// Turk, "The PLY Polygon File Format" (1994); the type names are those of vtkPLY.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace boxprobe {

/// vtkPLY reads lines into 4096 bytes, and writes "vertex_indices" over a "vertex_index" at their end.
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
  std::size_t begin = 0, end = 0;      ///< byte range of its line in the header, without the line end
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
  std::size_t lines = 0;                                          ///< up to and including end_header
  std::size_t body = 0;                                           ///< offset of the first byte of the body
  std::vector<std::pair<std::size_t, std::size_t>> longComments;  ///< byte ranges; longer than kLongestPlyLine
};

/// Throws InputError "PATH:LINE: reason"; line 0 omits the line.
[[noreturn]] void failPly(const std::string& path, std::size_t line, const std::string& reason);

/// Splits a line into words as vtkPLY does: at spaces, tabs and carriage returns.
void splitPlyLine(std::string_view line, std::vector<std::string_view>& words);

/// Throws InputError with the line. The result has a "vertex" with numbers x, y and z; "face", if present, has a list
/// "vertex_indices" (also from "vertex_index"); every element has fields; and each field that VTK looks for is a number
/// or a list, as VTK expects.
PlyHeader readPlyHeader(const std::string& path, const std::string& bytes);

}  // namespace boxprobe
