#include "filters/vtk/import/ply_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "filters/core/base/file_limits.h"
#include "filters/core/base/printable_text.h"
#include "filters/core/base/read_number.h"
#include "filters/io/files/read_file.h"
#include "filters/io/mesh/polygon_mesh.h"
#include "filters/io/mesh/polygon_triangles.h"
#include "filters/math/cube/srgb.h"
#include "filters/vtk/import/mesh_model.h"
#include "filters/vtk/import/ply_header.h"

namespace boxprobe {

namespace {

/// What a field of "vertex" or "face" is.
enum class PlyUse {
  None,
  X,
  Y,
  Z,
  NormalX,
  NormalY,
  NormalZ,
  U,
  V,
  Red,
  Green,
  Blue,
  Alpha,
  Corners,
  CornerUvs,
  Texture
};

struct PlyName {
  std::string_view name;
  PlyUse use;
};

constexpr PlyName kVertexNames[] = {{"x", PlyUse::X},          {"y", PlyUse::Y},         {"z", PlyUse::Z},
                                    {"nx", PlyUse::NormalX},   {"ny", PlyUse::NormalY},  {"nz", PlyUse::NormalZ},
                                    {"u", PlyUse::U},          {"v", PlyUse::V},         {"s", PlyUse::U},
                                    {"t", PlyUse::V},          {"texture_u", PlyUse::U}, {"texture_v", PlyUse::V},
                                    {"texture_s", PlyUse::U},  {"texture_t", PlyUse::V}, {"texcoord_u", PlyUse::U},
                                    {"texcoord_v", PlyUse::V}, {"tu", PlyUse::U},        {"tv", PlyUse::V}};
constexpr PlyName kColorNames[] = {{"red", PlyUse::Red},
                                   {"green", PlyUse::Green},
                                   {"blue", PlyUse::Blue},
                                   {"alpha", PlyUse::Alpha},
                                   {"r", PlyUse::Red},
                                   {"g", PlyUse::Green},
                                   {"b", PlyUse::Blue},
                                   {"a", PlyUse::Alpha},
                                   {"diffuse_red", PlyUse::Red},
                                   {"diffuse_green", PlyUse::Green},
                                   {"diffuse_blue", PlyUse::Blue},
                                   {"diffuse_alpha", PlyUse::Alpha}};

template <std::size_t Count>
PlyUse useIn(const PlyName (&names)[Count], std::string_view name) {
  for (const PlyName& entry : names) {
    if (entry.name == name) return entry.use;
  }
  return PlyUse::None;
}

bool isColor(PlyUse use) {
  return use >= PlyUse::Red && use <= PlyUse::Alpha;
}

bool isWhole(PlyType type) {
  return type != PlyType::Float32 && type != PlyType::Float64;
}

/// For messages.
std::string textOf(double number) {
  std::ostringstream text;
  text.precision(12);
  text << number;
  return text.str();
}

/// Independent of the locale. Counts and corners of integer types must be written as integers.
double numberOf(std::string_view word, bool whole, bool& valid) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char* end = word.data() + word.size();
  double value = 0.0;
  if (whole) {
    long long integer = 0;
    const auto result = std::from_chars(word.data(), end, integer);
    valid = result.ec == std::errc() && result.ptr == end;
    return static_cast<double>(integer);
  }
  const auto result = readNumber(word.data(), end, value);
  valid = result.ec != std::errc::invalid_argument && result.ptr == end;
  return result.ec == std::errc() ? value : std::numeric_limits<double>::quiet_NaN();
}

/// Old Macintosh files end lines with carriage returns: replaces them by line feeds, in the header and in a text body.
void endLinesByFeeds(std::string& bytes) {
  if (bytes.compare(0, 4, "ply\r") != 0 || bytes.compare(0, 5, "ply\r\n") == 0) return;
  const std::string last = "\rend_header\r";
  const std::size_t end = bytes.find(last);
  const bool text = bytes.find("\rformat ascii") < end;
  const std::size_t stop = text || end == std::string::npos ? bytes.size() : end + last.size();
  std::replace(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(stop), '\r', '\n');
}

/// The values of the body, in the order of the header.
class PlyValues {
 public:
  PlyValues(const std::string& path, const std::string& bytes, const PlyHeader& header)
      : path_(path),
        bytes_(bytes),
        text_(header.format == PlyFormat::Text),
        bigEndian_(header.format == PlyFormat::BigEndian),
        at_(header.body),
        line_(header.lines) {}

  void startElement(const PlyElementHead& element) { element_ = &element; }
  void startEntry(std::size_t entry) {
    entry_ = entry;
    if (text_) nextLine();
  }

  double next(PlyType type, const PlyField& field, bool whole) {
    return text_ ? nextWord(field, whole) : nextBinary(type);
  }

  /// A list's count, checked to fit into the rest of the line or file.
  std::size_t nextCount(const PlyField& field) {
    const double count = next(field.countType, field, isWhole(field.countType));
    if (!(count >= 0 && count <= std::numeric_limits<int>::max() && count == std::floor(count))) {
      fail("a list of " + textOf(count) + " entries is not possible; the file is damaged");
    }
    const auto whole = static_cast<std::size_t>(count);
    if (text_ && whole > words_.size() - word_) {
      fail("\"" + field.name + "\" is a list of " + std::to_string(whole) + ", but " +
           std::to_string(words_.size() - word_) + " words follow; complete the line or correct the count");
    }
    if (!text_ && whole > (bytes_.size() - at_) / sizeInBytes(field.type)) {
      fail("\"" + field.name + "\" is a list of " + std::to_string(whole) +
           ", more than the rest of the file holds; the file is damaged or cut off");
    }
    return whole;
  }

  /// The position is a line in text, an entry of the element in binary data.
  [[noreturn]] void fail(const std::string& reason) const {
    if (text_) failPly(path_, line_, reason);
    failPly(path_, 0, element_->name + " " + std::to_string(entry_) + ": " + reason);
  }
  double done() const { return static_cast<double>(at_) / static_cast<double>(bytes_.size()); }

 private:
  [[noreturn]] void failCutOff() const {
    const std::string promised = std::to_string(element_->count) + " of \"" + element_->name + "\" are promised";
    fail("the file ends here, but " + promised + "; the file is cut off");
  }

  void nextLine() {
    word_ = 0;
    do {  // empty lines hold nothing: every entry has a word
      ++line_;
      if (at_ >= bytes_.size()) failCutOff();
      const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
      splitPlyLine(std::string_view(bytes_).substr(at_, end - at_), words_);
      at_ = end + 1;
    } while (words_.empty());
  }

  double nextWord(const PlyField& field, bool whole) {
    if (word_ == words_.size()) {
      fail("the line has " + std::to_string(words_.size()) + " words, too few for \"" + field.name +
           "\"; complete the line");
    }
    const std::string_view word = words_[word_++];
    bool valid = false;
    const double value = numberOf(word, whole, valid);
    if (!valid) {
      fail("\"" + std::string(word.substr(0, 40)) + "\" is not a " + (whole ? "whole " : "") + "number (\"" +
           field.name + "\"); correct it");
    }
    return value;
  }

  template <typename T>
  double binaryNumber() const {
    unsigned char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + at_, sizeof(T));
    if (bigEndian_) std::reverse(raw, raw + sizeof(T));  // x86 and ARM are little-endian
    T value;
    std::memcpy(&value, raw, sizeof(T));
    return static_cast<double>(value);
  }

  double nextBinary(PlyType type) {
    if (bytes_.size() - at_ < sizeInBytes(type)) failCutOff();
    double value = 0.0;
    switch (type) {
      case PlyType::Int8:
        value = binaryNumber<std::int8_t>();
        break;
      case PlyType::Uint8:
        value = binaryNumber<std::uint8_t>();
        break;
      case PlyType::Int16:
        value = binaryNumber<std::int16_t>();
        break;
      case PlyType::Uint16:
        value = binaryNumber<std::uint16_t>();
        break;
      case PlyType::Int32:
        value = binaryNumber<std::int32_t>();
        break;
      case PlyType::Uint32:
        value = binaryNumber<std::uint32_t>();
        break;
      case PlyType::Float32:
        value = binaryNumber<float>();
        break;
      case PlyType::Float64:
        value = binaryNumber<double>();
        break;
    }
    at_ += sizeInBytes(type);
    return value;
  }

  const std::string& path_;
  const std::string& bytes_;
  const bool text_, bigEndian_;
  const PlyElementHead* element_ = nullptr;
  std::vector<std::string_view> words_;
  std::size_t at_, line_, entry_ = 0, word_ = 0;
};

class PlyReader {
 public:
  PlyReader(const std::string& path, const LoadProgress& progress) : path_(path), progress_(progress) {
    bytes_ = readWholeFile(path);
    endLinesByFeeds(bytes_);
    header_ = readPlyHeader(path, bytes_);
    for (const PlyElementHead& element : header_.elements) {
      if (element.name == "vertex") vertices_ = element.count;
      if (element.name == "face") facesPromised_ = element.count;
    }
  }

  Model read() {
    PlyValues values(path_, bytes_, header_);
    // What stands behind these may be anything.
    const auto known = [](const PlyElementHead& element) {
      return element.name == "vertex" || element.name == "face" || element.name == "tristrips";
    };
    std::size_t needed = header_.elements.size();
    while (needed > 0 && !known(header_.elements[needed - 1])) --needed;
    for (std::size_t e = 0; e < needed; ++e) readElement(values, header_.elements[e]);
    for (std::size_t e = needed; e < header_.elements.size(); ++e) leaveOut(header_.elements[e]);
    decodeColors(polygons_.colors, "vertex colours");
    decodeColors(polygons_.faceColors, "face colours");
    MeshModel made(path_);
    made.model().warnings = takeWarnings();
    for (const std::string& texture : header_.textures) made.addPicture(texture);
    const std::size_t parts = std::max<std::size_t>(header_.textures.size(), 1);
    made.add(polygons_, parts, transparent_);
    return made.take();
  }

 private:
  void readElement(PlyValues& values, const PlyElementHead& element) {
    values.startElement(element);
    const bool vertex = element.name == "vertex", face = element.name == "face";
    // The corners of strips repeat those of faces, if there are any.
    const bool strips = element.name == "tristrips" && facesPromised_ == 0;
    if (!vertex && !face && !strips) leaveOut(element);
    std::vector<PlyUse> uses;
    for (const PlyField& field : element.fields) {
      uses.push_back(useOf(element, field, strips));
      if ((vertex || face) && uses.back() == PlyUse::None && element.count > 0)
        leftOut_.insert(element.name + " " + field.name);
    }
    startArrays(element, uses);
    for (std::size_t entry = 0; entry < element.count; ++entry) {
      values.startEntry(entry);
      for (std::size_t f = 0; f < uses.size(); ++f) readField(values, element.fields[f], uses[f], entry);
      if (face) finishFace(values);
      if (strips) finishStrip(values);
      constexpr std::size_t kBetween = 1 << 15;
      if (entry % kBetween == 0 && progress_ && !progress_(0.6 * values.done())) {
        throw LoadCancelled(path_ + ": loading was cancelled");
      }
    }
  }

  void leaveOut(const PlyElementHead& element) {
    if (element.count > 0) leftOut_.insert("element " + element.name);
  }

  static PlyUse useOf(const PlyElementHead& element, const PlyField& field, bool strips) {
    if (field.isList) {
      if ((element.name == "face" || strips) && field.name == "vertex_indices") return PlyUse::Corners;
      return element.name == "face" && field.name == "texcoord" ? PlyUse::CornerUvs : PlyUse::None;
    }
    if (element.name != "vertex" && element.name != "face") return PlyUse::None;
    if (element.name == "face" && field.name == "texnumber") return PlyUse::Texture;
    const PlyUse use = element.name == "vertex" ? useIn(kVertexNames, field.name) : PlyUse::None;
    return use != PlyUse::None ? use : useIn(kColorNames, field.name);
  }

  void startArrays(const PlyElementHead& element, const std::vector<PlyUse>& uses) {
    const auto has = [&](PlyUse use) { return std::find(uses.begin(), uses.end(), use) != uses.end(); };
    const bool colored = has(PlyUse::Red) && has(PlyUse::Green) && has(PlyUse::Blue);
    if (element.name == "vertex") {
      polygons_.positions.resize(element.count);
      if (has(PlyUse::NormalX) && has(PlyUse::NormalY) && has(PlyUse::NormalZ)) polygons_.normals.resize(element.count);
      if (has(PlyUse::U) && has(PlyUse::V)) polygons_.uvs.resize(element.count);
      if (colored) polygons_.colors.assign(element.count, glm::vec4(1.0f));
      colors_ = &polygons_.colors;
    } else if (element.name == "face") {
      if (colored) polygons_.faceColors.assign(element.count, glm::vec4(1.0f));
      hasCornerUvs_ = has(PlyUse::CornerUvs);
      colors_ = &polygons_.faceColors;
    }
  }

  void readField(PlyValues& values, const PlyField& field, PlyUse use, std::size_t entry) {
    if (field.isList) {
      const std::size_t count = values.nextCount(field);
      const bool corners = use == PlyUse::Corners;
      std::vector<double>* to = corners ? &corners_ : use == PlyUse::CornerUvs ? &cornerUvs_ : nullptr;
      if (to != nullptr) to->clear();
      for (std::size_t i = 0; i < count; ++i) {
        const double value = values.next(field.type, field, corners && isWhole(field.type));
        if (to != nullptr) to->push_back(value);
      }
      return;
    }
    const double value = values.next(field.type, field, false);
    if (use >= PlyUse::X && use <= PlyUse::Z) {
      polygons_.positions[entry][static_cast<int>(use) - static_cast<int>(PlyUse::X)] = value;
    } else if (use >= PlyUse::NormalX && use <= PlyUse::NormalZ && !polygons_.normals.empty()) {
      polygons_.normals[entry][static_cast<int>(use) - static_cast<int>(PlyUse::NormalX)] = value;
    } else if ((use == PlyUse::U || use == PlyUse::V) && !polygons_.uvs.empty()) {
      polygons_.uvs[entry][use == PlyUse::U ? 0 : 1] = value;
    } else if (isColor(use) && !colors_->empty()) {
      (*colors_)[entry][static_cast<int>(use) - static_cast<int>(PlyUse::Red)] = shareOf(field.type, value);
    } else if (use == PlyUse::Texture) {
      texture_ = value;
    }
  }

  /// Of the type's maximum for integers, of 1 for floats; 0 for NaN.
  float shareOf(PlyType type, double value) {
    const double full = !isWhole(type)           ? 1.0
                        : sizeInBytes(type) == 1 ? 255.0
                        : sizeInBytes(type) == 2 ? 65535.0
                                                 : 4294967295.0;
    if (type == PlyType::Int8 && value < 0.0) value += 256.0;  // a byte all the same
    const double share = value >= 0.0 ? std::min(value / full, 255.0) : 0.0;
    return static_cast<float>(share);
  }

  void checkCorner(const PlyValues& values, double corner) const {
    if (corner >= 0 && corner < static_cast<double>(vertices_)) return;
    values.fail("corner " + textOf(corner) + " is not among the " + std::to_string(vertices_) +
                " vertices, which count from 0; the file is damaged");
  }

  void finishFace(const PlyValues& values) {
    if (corners_.size() > limits::kPolygonCorners) {
      values.fail("the polygon has " + std::to_string(corners_.size()) + " corners; split it, " +
                  std::to_string(limits::kPolygonCorners) + " are possible");
    }
    const bool pictured = cornerUvs_.size() == 2 * corners_.size();
    if (hasCornerUvs_ && !pictured && !cornerUvs_.empty()) leftOut_.insert("face texcoord of another length");
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      checkCorner(values, corners_[i]);
      polygons_.corners.push_back(static_cast<std::uint32_t>(corners_[i]));
      if (!hasCornerUvs_) continue;
      polygons_.cornerUvs.push_back(pictured ? glm::dvec2(cornerUvs_[2 * i], cornerUvs_[2 * i + 1]) : glm::dvec2(0.0));
    }
    polygons_.ends.push_back(polygons_.corners.size());
    if (header_.textures.size() > 1) {
      const bool known = texture_ >= 0.0 && texture_ < static_cast<double>(header_.textures.size());
      polygons_.parts.push_back(known ? static_cast<std::uint32_t>(texture_) : 0);
    } else if (texture_ != 0.0 && texture_ != -1.0) {
      leftOut_.insert("face texnumber");
    }
  }

  /// Each corner forms a triangle with the two before it, with alternating winding; -1 ends a strip.
  void finishStrip(const PlyValues& values) {
    std::vector<std::uint32_t> strip;
    for (const double corner : corners_) {
      if (corner < 0) {
        strip.clear();
        continue;
      }
      checkCorner(values, corner);
      strip.push_back(static_cast<std::uint32_t>(corner));
      const std::size_t n = strip.size();
      if (n < 3) continue;
      const std::size_t odd = n % 2 == 0 ? 1 : 0;
      const std::uint32_t a = strip[n - 3], b = strip[n - 2 + odd], c = strip[n - 1 - odd];
      if (a == b || b == c || a == c) continue;
      polygons_.corners.insert(polygons_.corners.end(), {a, b, c});
      polygons_.ends.push_back(polygons_.corners.size());
    }
  }

  /// From sRGB. Floating-point colours above 1 are bytes.
  void decodeColors(std::vector<glm::vec4>& colors, const std::string& called) {
    float largest = 0.0f, leastAlpha = 1.0f, mostAlpha = 0.0f;
    for (const glm::vec4& color : colors) largest = std::max({largest, color.r, color.g, color.b, color.a});
    const float full = largest > 1.0f ? 255.0f : 1.0f;
    if (full > 1.0f) warnings_.push_back("has " + called + " above 1, which are read as 0 to 255");
    for (glm::vec4& color : colors) {
      for (int i = 0; i < 3; ++i) {
        color[i] = static_cast<float>(linearOfSrgbValue(std::min(static_cast<double>(color[i] / full), 1.0)));
      }
      color.a = std::min(color.a / full, 1.0f);
      leastAlpha = std::min(leastAlpha, color.a);
      mostAlpha = std::max(mostAlpha, color.a);
    }
    if (colors.empty() || leastAlpha == 1.0f) return;
    if (mostAlpha > 0.0f) {
      transparent_ = true;
      return;
    }
    warnings_.push_back("has " + called + " with an alpha of 0 everywhere, which are drawn opaque");
    for (glm::vec4& color : colors) color.a = 1.0f;
  }

  std::vector<std::string> takeWarnings() {
    std::string text;
    for (const std::string& what : leftOut_) text += (text.empty() ? "" : ", ") + printable(what.substr(0, 60));
    if (!text.empty()) warnings_.push_back(leftOutWarning("has data that is not drawn: ", text));
    return std::move(warnings_);
  }

  const std::string& path_;
  const LoadProgress& progress_;
  std::string bytes_;
  PlyHeader header_;
  Polygons polygons_;
  std::vector<glm::vec4>* colors_ = nullptr;  ///< of the element being read
  std::vector<double> corners_, cornerUvs_;   ///< of the entry being read
  double texture_ = 0.0;
  bool hasCornerUvs_ = false, transparent_ = false;
  std::size_t vertices_ = 0, facesPromised_ = 0;
  std::set<std::string> leftOut_;
  std::vector<std::string> warnings_;
};

}  // namespace

Model readPly(const std::string& path, const LoadProgress& progress) {
  return PlyReader(path, progress).read();
}

}  // namespace boxprobe
