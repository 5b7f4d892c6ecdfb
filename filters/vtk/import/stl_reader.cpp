#include "filters/vtk/import/stl_reader.h"

#include <cctype>
#include <cmath>
#include <cstring>
#include <string_view>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/core/base/read_number.h"
#include "filters/io/files/decimal_comma.h"
#include "filters/io/files/read_file.h"
#include "filters/io/mesh/polygon_mesh.h"
#include "filters/math/cube/srgb.h"
#include "filters/vtk/import/mesh_model.h"

namespace boxprobe {

namespace {

constexpr std::size_t kStlHeader = 84, kStlTriangle = 50;

[[noreturn]] void failStl(const std::string& path, const std::string& place, const std::string& reason) {
  throw InputError(oneLine(path + place + ": " + reason));
}

/// The count in a binary file's header. STL is little-endian, as are the supported processors.
std::size_t promisedTriangles(const std::string& bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kStlHeader - sizeof count, sizeof count);
  return count;
}

bool isStlWord(std::string_view word, std::string_view wanted) {
  if (word.size() != wanted.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (std::tolower(static_cast<unsigned char>(word[i])) != wanted[i]) return false;
  }
  return true;
}

/// Some binary files also start with "solid". Their size tells, or a zero byte near the start: text has none, and the
/// header or the count behind it always has one below 2^24 triangles.
bool isStlText(const std::string& bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start == std::string::npos || !isStlWord(std::string_view(bytes).substr(start, 5), "solid")) return false;
  if (bytes.find("facet") == std::string::npos && bytes.find("FACET") == std::string::npos) return false;
  if (bytes.size() < kStlHeader) return true;
  if (bytes.size() == kStlHeader + kStlTriangle * promisedTriangles(bytes)) return false;
  return std::string_view(bytes).substr(0, kStlHeader + kStlTriangle).find('\0') == std::string_view::npos;
}

class StlProgress {
 public:
  StlProgress(const std::string& path, const LoadProgress& progress) : path_(path), progress_(progress) {}
  void triangle(double done) {
    constexpr std::size_t kBetween = 1 << 16;
    if (++triangles_ % kBetween == 0 && progress_ && !progress_(0.8 * done)) {
      throw LoadCancelled(path_ + ": loading was cancelled");
    }
  }

 private:
  const std::string& path_;
  const LoadProgress& progress_;
  std::size_t triangles_ = 0;
};

void addStlVertex(Polygons& mesh, const glm::dvec3& position) {
  mesh.corners.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
  mesh.positions.push_back(position);
  if (mesh.corners.size() % 3 == 0) mesh.ends.push_back(mesh.corners.size());
}

/// Five bits each, as sRGB, from the bit of the first component upwards.
glm::vec4 stlColor(unsigned bits, int red, int green, int blue) {
  const auto share = [&](int shift) {
    return static_cast<float>(linearOfSrgbValue(static_cast<double>((bits >> shift) & 31u) / 31.0));
  };
  return {share(red), share(green), share(blue), 1.0f};
}

/// The two bytes behind each triangle. VisCAM and SolidView: the highest bit says that there is a colour, blue has the
/// lowest bits. Magics: the header holds "COLOR=" and four bytes; the highest bit says that this colour holds, else red
/// has the lowest bits.
class StlColors {
 public:
  explicit StlColors(const std::string& bytes) {
    constexpr std::string_view kKey = "COLOR=";
    const std::string_view header = std::string_view(bytes).substr(0, kStlHeader - 4);
    const std::size_t at = header.find(kKey);
    magics_ = at != std::string_view::npos && at + kKey.size() + 4 <= header.size();
    if (!magics_) return;
    for (int i = 0; i < 3; ++i) {
      default_[i] = linearOfSrgb(static_cast<std::uint8_t>(header[at + kKey.size() + static_cast<std::size_t>(i)]));
    }
    transparent_ = static_cast<unsigned char>(header[at + kKey.size() + 3]) < 255;
    colored_ = true;
  }

  void take(unsigned attribute) {
    const bool flag = (attribute & 0x8000u) != 0;
    if (magics_) {
      colors_.push_back(flag ? default_ : stlColor(attribute, 0, 5, 10));
    } else {
      colored_ = colored_ || flag;
      other_ = other_ || (!flag && attribute != 0);
      colors_.push_back(flag ? stlColor(attribute, 10, 5, 0) : default_);
    }
  }

  void finish(Polygons& mesh, std::vector<std::string>& warnings) {
    if (transparent_) warnings.emplace_back("has a colour with an alpha, which is drawn opaque");
    if (other_) warnings.emplace_back("has attribute bytes that are not colours, which are left out");
    if (colored_) mesh.faceColors = std::move(colors_);
  }

 private:
  bool magics_ = false, colored_ = false, other_ = false, transparent_ = false;
  glm::vec4 default_{0.8f, 0.8f, 0.8f, 1.0f};  ///< as without colours
  std::vector<glm::vec4> colors_;
};

void readStlBinary(const std::string& path, const std::string& bytes, StlProgress& progress, Polygons& mesh,
                   std::vector<std::string>& warnings) {
  if (bytes.size() < kStlHeader) failStl(path, "", "is cut off: a binary STL file has a header of 84 bytes");
  const std::size_t held = (bytes.size() - kStlHeader) / kStlTriangle;
  std::size_t count = promisedTriangles(bytes);
  if (count == 0 && held > 0 && bytes.size() == kStlHeader + kStlTriangle * held) {
    count = held;  // programs that write while they count leave 0 there if they cannot go back
    warnings.emplace_back("promises 0 triangles and holds " + std::to_string(held) + ", which are read");
  }
  if (count == 0) failStl(path, "", "has no triangles");
  if (count > held) {
    failStl(path, "",
            "promises " + std::to_string(count) + " triangles, but holds " + std::to_string(held) +
                "; the file is cut off");
  }
  mesh.positions.reserve(3 * count);
  mesh.corners.reserve(3 * count);
  StlColors colors(bytes);
  for (std::size_t t = 0; t < count; ++t) {
    float numbers[9];  // after the normal
    std::memcpy(numbers, bytes.data() + kStlHeader + kStlTriangle * t + 12, sizeof numbers);
    for (std::size_t k = 0; k < 9; k += 3) addStlVertex(mesh, {numbers[k], numbers[k + 1], numbers[k + 2]});
    std::uint16_t attribute = 0;
    std::memcpy(&attribute, bytes.data() + kStlHeader + kStlTriangle * t + 48, sizeof attribute);
    colors.take(attribute);
    progress.triangle(static_cast<double>(t) / static_cast<double>(count));
  }
  colors.finish(mesh, warnings);
}

/// The words of a text with their line numbers. Carriage returns alone also end lines.
class StlWords {
 public:
  explicit StlWords(const std::string& bytes) : bytes_(bytes) {}

  /// Empty at the end.
  std::string_view next() {
    while (at_ < bytes_.size() && std::isspace(static_cast<unsigned char>(bytes_[at_])) != 0) step();
    const std::size_t start = at_;
    while (at_ < bytes_.size() && std::isspace(static_cast<unsigned char>(bytes_[at_])) == 0) ++at_;
    return std::string_view(bytes_).substr(start, at_ - start);
  }
  void skipLine() {
    while (at_ < bytes_.size() && bytes_[at_] != '\n' && bytes_[at_] != '\r') ++at_;
  }
  std::string place() const { return ":" + std::to_string(line_); }
  double done() const { return static_cast<double>(at_) / static_cast<double>(bytes_.size()); }

 private:
  void step() {
    const bool pair = bytes_[at_] == '\r' && at_ + 1 < bytes_.size() && bytes_[at_ + 1] == '\n';
    if (bytes_[at_] == '\n' || (bytes_[at_] == '\r' && !pair)) ++line_;
    ++at_;
  }

  const std::string& bytes_;
  std::size_t at_ = 0, line_ = 1;
};

void readStlText(const std::string& path, const std::string& bytes, StlProgress& progress, Polygons& mesh,
                 std::vector<std::string>& warnings) {
  StlWords words(bytes);
  bool commas = false;
  const auto number = [&] {
    std::string_view word = words.next();
    const std::string told(word.substr(0, 40));
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    double value = 0.0;
    const auto result = readNumber(word.data(), word.data() + word.size(), value);
    if (const auto comma = decimalCommaNumber(word)) {
      commas = true;
      return *comma;
    }
    if (result.ec == std::errc::invalid_argument || result.ptr != word.data() + word.size()) {
      failStl(path, words.place(), "\"" + told + "\" is not a number; \"vertex\" has three");
    }
    return result.ec == std::errc() ? value : 0.0;  // underflow, or overflow, which no real model has
  };
  std::size_t corners = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (isStlWord(word, "solid") || isStlWord(word, "endsolid")) {
      words.skipLine();  // the name
    } else if (isStlWord(word, "vertex")) {
      const double x = number(), y = number(), z = number();
      addStlVertex(mesh, {x, y, z});
      ++corners;
    } else if (isStlWord(word, "endloop")) {
      if (corners != 3) {
        failStl(path, words.place(), "the loop has " + std::to_string(corners) + " vertices; STL has triangles alone");
      }
      corners = 0;
      progress.triangle(words.done());
    } else if (isStlWord(word, "facet")) {
      words.skipLine();  // its normal
    } else if (!isStlWord(word, "outer") && !isStlWord(word, "loop") && !isStlWord(word, "endfacet")) {
      failStl(path, words.place(), "\"" + std::string(word.substr(0, 40)) + "\" is not of STL; the file is damaged");
    }
  }
  if (corners != 0) failStl(path, words.place(), "the file ends within a loop; it is cut off");
  if (commas) warnings.emplace_back(kDecimalCommas);
}

}  // namespace

Model readStl(const std::string& path, const LoadProgress& progress) {
  std::string bytes = readWholeFile(path);
  if (bytes.compare(0, 8, "\xef\xbb\xbfsolid") == 0) bytes.erase(0, 3);  // a byte order mark
  StlProgress reported(path, progress);
  Polygons mesh;
  MeshModel made(path);
  if (isStlText(bytes)) {
    readStlText(path, bytes, reported, mesh, made.model().warnings);
  } else {
    readStlBinary(path, bytes, reported, mesh, made.model().warnings);
  }
  made.add(mesh, 1, false);
  return made.take();
}

}  // namespace boxprobe
