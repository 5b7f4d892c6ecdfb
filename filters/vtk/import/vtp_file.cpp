#include "filters/vtk/import/vtp_file.h"

#include <expat.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <memory>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/read_file.h"

namespace boxprobe {

namespace {

/// Deflate's maximum ratio is 1032, the highest of VTK's compressors.
constexpr std::size_t kMostOfAByte = 1032;

// Expat 2.9 has wider counts and deprecates the earlier function.
std::uint64_t lineOf(XML_Parser parser) {
#if XML_MAJOR_VERSION > 2 || (XML_MAJOR_VERSION == 2 && XML_MINOR_VERSION >= 9)
  return XML_GetCurrentLineNumber64(parser);
#else
  return XML_GetCurrentLineNumber(parser);
#endif
}

class VtpXml {
 public:
  VtpXml(const std::string& path, VtpFile& file) : path_(path), file_(file) {}

  void read() {
    const std::string& bytes = file_.bytes;
    if (bytes.find("<VTKFile") == std::string::npos) failVtp(path_, "is not a VTK XML file; save it as VTP");
    // Appended data may be binary: for the XML parser the file ends before it.
    const std::size_t appended = bytes.find("<AppendedData");
    const std::size_t length = std::min(appended, bytes.size());
    const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
    if (!parser || length > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
      failVtp(path_, "is too large to be read as XML; save it with appended data");
    }
    XML_SetUserData(parser.get(), this);
    XML_SetElementHandler(
        parser.get(),
        [](void* self, const char* name, const char** attributes) {
          static_cast<VtpXml*>(self)->guarded([&](VtpXml& xml) { xml.start(name, attributes); });
        },
        [](void* self, const char* name) { static_cast<VtpXml*>(self)->end(name); });
    XML_SetCharacterDataHandler(parser.get(), [](void* self, const char* text, int count) {
      static_cast<VtpXml*>(self)->text(text, static_cast<std::size_t>(count));
    });
    parser_ = parser.get();
    const bool whole = appended == std::string::npos;
    const auto status = XML_Parse(parser.get(), bytes.data(), static_cast<int>(length), whole ? 1 : 0);
    if (!error_.empty()) failVtp(path_, error_);
    if (status != XML_STATUS_OK) {
      throw InputError(oneLine(path_ + ":" + std::to_string(lineOf(parser.get())) +
                               ": is not XML: " + XML_ErrorString(XML_GetErrorCode(parser.get())) + "; save it again"));
    }
    if (file_.pieces.empty()) failVtp(path_, "holds no PolyData; save it as VTP");
    if (!whole) findAppended(appended);
  }

 private:
  /// Exceptions must not pass through the parser, which is C.
  template <typename Action>
  void guarded(Action action) {
    if (!error_.empty()) return;
    try {
      action(*this);
    } catch (const std::exception& problem) {
      error_ = problem.what();
      XML_StopParser(parser_, XML_FALSE);
    }
  }

  static std::string attribute(const char** attributes, const std::string& name, const std::string& otherwise = {}) {
    for (; *attributes != nullptr; attributes += 2) {
      if (name == attributes[0]) return attributes[1];
    }
    return otherwise;
  }

  std::size_t count(const char** attributes, const std::string& name, std::size_t otherwise, std::size_t most) const {
    const std::string text = attribute(attributes, name);
    if (text.empty()) return otherwise;
    std::size_t value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size() || value > most) {
      throw InputError(name + "=\"" + text + "\" is more than the file holds");
    }
    return value;
  }

  void start(const std::string& name, const char** attributes) {
    if (array_ != nullptr) {
      ++nested_;  // attributes of an array, not its values
      return;
    }
    const std::size_t most = kMostOfAByte * file_.bytes.size();
    if (name == "VTKFile") {
      if (attribute(attributes, "type") != "PolyData") throw InputError("holds no PolyData; save it as VTP");
      file_.bigEndian = attribute(attributes, "byte_order") == "BigEndian";
      file_.wideHeaders = attribute(attributes, "header_type") == "UInt64";
      file_.compressor = attribute(attributes, "compressor");
    } else if (name == "Piece") {
      if (file_.pieces.size() == limits::kVtpPieces)
        throw InputError("has more than " + std::to_string(limits::kVtpPieces) + " pieces; save it as one");
      VtpPiece piece;
      piece.points = count(attributes, "NumberOfPoints", 0, most);
      piece.verts = count(attributes, "NumberOfVerts", 0, most);
      piece.lines = count(attributes, "NumberOfLines", 0, most);
      piece.polys = count(attributes, "NumberOfPolys", 0, most);
      piece.strips = count(attributes, "NumberOfStrips", 0, most);
      file_.pieces.push_back(std::move(piece));
    } else if (name == "DataArray") {
      startArray(attributes, most);
    } else {
      section_ = name;
      if (name == "PointData" && !file_.pieces.empty()) {
        file_.pieces.back().normals = attribute(attributes, "Normals");
        file_.pieces.back().uv = attribute(attributes, "TCoords");
      }
    }
  }

  void startArray(const char** attributes, std::size_t most) {
    array_ = nullptr;
    if (file_.pieces.empty()) return;  // field data
    std::vector<VtpArray>& arrays = file_.pieces.back().arrays;
    if (arrays.size() == limits::kVtpArrays)
      throw InputError("has more than " + std::to_string(limits::kVtpArrays) + " arrays in a piece; leave some out");
    VtpArray array;
    array.section = section_;
    array.name = attribute(attributes, "Name");
    array.type = attribute(attributes, "type");
    const std::string format = attribute(attributes, "format", "ascii");
    array.format = format == "ascii" ? VtpFormat::Text : format == "appended" ? VtpFormat::Appended : VtpFormat::Base64;
    array.components = count(attributes, "NumberOfComponents", 1, 64);
    array.offset = count(attributes, "offset", 0, most);
    arrays.push_back(std::move(array));
    array_ = &arrays.back();
  }

  void end(const std::string& name) {
    if (nested_ > 0) {
      --nested_;
    } else if (name == "DataArray") {
      array_ = nullptr;
    }
  }
  void text(const char* text, std::size_t count) {
    if (array_ != nullptr && nested_ == 0 && array_->format != VtpFormat::Appended) array_->text.append(text, count);
  }

  void findAppended(std::size_t element) {
    const std::string& bytes = file_.bytes;
    const std::size_t close = bytes.find('>', element), mark = bytes.find('_', close);
    if (close == std::string::npos || mark == std::string::npos) failVtp(path_, "is cut off at its appended data");
    file_.appendedBase64 = bytes.substr(element, close - element).find("base64") != std::string::npos;
    file_.appended = mark + 1;
  }

  const std::string& path_;
  VtpFile& file_;
  XML_Parser parser_ = nullptr;
  std::string section_, error_;
  VtpArray* array_ = nullptr;
  std::size_t nested_ = 0;
};

}  // namespace

const VtpArray* VtpPiece::find(const std::string& section, const std::string& name) const {
  for (const VtpArray& array : arrays) {
    if (array.section == section && (name.empty() || array.name == name)) return &array;
  }
  return nullptr;
}

VtpFile readVtpFile(const std::string& path) {
  VtpFile file;
  file.bytes = readWholeFile(path);
  VtpXml(path, file).read();
  return file;
}

void failVtp(const std::string& path, const std::string& reason) {
  throw InputError(oneLine(path + ": " + reason));
}

}  // namespace boxprobe
