// Parses the XML of a VTP file: its arrays, and where their bytes are. Source: "VTK XML File Formats" (docs.vtk.org)
// and, where that is silent, the output of VTK 9.1.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace boxprobe {

enum class VtpFormat { Text, Base64, Appended };

struct VtpArray {
  std::string section;  ///< section of the piece: "Points", "Polys", "PointData" ...
  std::string name, type;
  VtpFormat format = VtpFormat::Text;
  std::size_t components = 1;
  std::size_t offset = 0;  ///< of appended arrays, relative to the underscore
  std::string text;        ///< of other arrays
};

struct VtpPiece {
  std::size_t points = 0, verts = 0, lines = 0, polys = 0, strips = 0;
  std::string normals, uv;  ///< names of arrays of PointData
  std::vector<VtpArray> arrays;

  /// Null if there is none.
  const VtpArray* find(const std::string& section, const std::string& name) const;
};

struct VtpFile {
  std::string bytes;
  bool bigEndian = false, wideHeaders = false;  ///< counts before data have 8 bytes instead of 4
  std::string compressor;                       ///< name of VTK's class; empty: uncompressed
  bool appendedBase64 = false;
  std::size_t appended = std::string::npos;  ///< offset of the first byte after the underscore
  std::vector<VtpPiece> pieces;
};

/// Throws InputError for invalid XML, other data than PolyData, and sizes that a file of this length cannot contain.
VtpFile readVtpFile(const std::string& path);

/// The values of an array in any encoding: exactly `wanted` values. Throws InputError with the array; nothing is
/// decompressed before its size is known to match.
std::vector<double> vtpValues(const VtpFile& file, const VtpArray& array, std::size_t wanted, const std::string& path);

[[noreturn]] void failVtp(const std::string& path, const std::string& reason);

}  // namespace boxprobe
