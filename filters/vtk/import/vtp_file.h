// The XML of a VTP file: which arrays there are and where their bytes lie. Called by the VTP reader. Knows no VTK.
// Source: "VTK XML File Formats" (docs.vtk.org); where it says nothing, what VTK 9.1 writes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace boxprobe {

enum class VtpFormat { Text, Base64, Appended };

struct VtpArray {
  std::string section;  ///< of the piece: "Points", "Polys", "PointData" ...
  std::string name, type;
  VtpFormat format = VtpFormat::Text;
  std::size_t components = 1;
  std::size_t offset = 0;  ///< of appended ones, behind the underscore
  std::string text;        ///< of the others
};

struct VtpPiece {
  std::size_t points = 0, polys = 0, strips = 0;
  std::string normals, uv;  ///< names of arrays of PointData
  std::vector<VtpArray> arrays;

  /// Null if there is none.
  const VtpArray* find(const std::string& section, const std::string& name) const;
};

struct VtpFile {
  std::string bytes;
  bool bigEndian = false, wideHeaders = false;  ///< counts before data have 8 bytes, else 4
  std::string compressor;                       ///< VTK's class; empty: none
  bool appendedBase64 = false;
  std::size_t appended = std::string::npos;  ///< the first byte behind the underscore
  std::vector<VtpPiece> pieces;
};

/// Throws InputError for what is no XML, or no PolyData, or promises more than a file of its size can hold.
VtpFile readVtpFile(const std::string& path);

[[noreturn]] void failVtp(const std::string& path, const std::string& reason);

}  // namespace boxprobe
