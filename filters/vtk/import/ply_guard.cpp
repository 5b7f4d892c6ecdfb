#include "filters/vtk/import/ply_guard.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <string_view>
#include <vector>

#include "filters/io/files/read_file.h"
#include "filters/vtk/import/ply_header.h"

namespace boxprobe {

namespace {

constexpr std::size_t kMostCorners = 255;  // VTK counts them in a byte

/// The index of the field of "face" that VTK reads as corners: the first of that name. Other elements have none.
std::size_t cornersOf(const PlyElementHead& element) {
  std::size_t index = 0;
  while (index < element.fields.size() && element.fields[index].name != "vertex_indices") ++index;
  return element.name == "face" ? index : element.fields.size();
}

/// For messages.
std::string textOf(double number) {
  std::ostringstream text;
  text.precision(12);
  text << number;
  return text.str();
}

/// Parses a number independent of the locale. Counts and corners of integer types must be written as integers: VTK
/// would read "1e1" as 1.
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
  const auto result = std::from_chars(word.data(), end, value);
  valid = result.ec != std::errc::invalid_argument && result.ptr == end;
  return result.ec == std::errc() ? value : std::numeric_limits<double>::quiet_NaN();
}

bool isWhole(PlyType type) {
  return type != PlyType::Float32 && type != PlyType::Float64;
}

class BodyCheck {
 public:
  BodyCheck(const std::string& path, std::string& bytes, const PlyHeader& header)
      : path_(path), bytes_(bytes), header_(header), at_(header.body), line_(header.lines) {}

  /// Elements after "vertex" and "face" are not checked: VTK does not read them.
  void check() {
    const auto named = [&](const char* name) {
      return std::find_if(header_.elements.begin(), header_.elements.end(), [&](auto& e) { return e.name == name; });
    };
    const auto vertex = named("vertex"), face = named("face");
    if (face < vertex) failPly(path_, face->line, "\"face\" stands before \"vertex\"; put the vertices first");
    const auto last = face == header_.elements.end() ? vertex : face;
    vertices_ = vertex->count;
    for (auto element = header_.elements.begin(); element <= last; ++element) {
      colorSlots_ = colorSlotsOf(*element);
      if (colored()) colors_.assign(element->count, {255, 255, 255, 255});
      if (element->count == 0) continue;
      if (element != vertex && element != face) {
        failPly(path_, element->line,
                "element \"" + element->name + "\" stands before \"" + last->name + "\"; put it behind or delete it");
      }
      if (header_.format == PlyFormat::Text) {
        checkText(*element);
      } else {
        checkBinary(*element);
      }
    }
    const auto next = last + 1;
    const bool noFaces = face == header_.elements.end() || face->count == 0;
    if (noFaces && next < header_.elements.end() && next->name == "tristrips") readStrips(*next);
  }

  std::vector<std::array<std::uint8_t, 4>> takeColors() { return std::move(colors_); }
  std::vector<std::uint32_t> takeTriangles() { return std::move(triangles_); }
  bool changed() const { return changed_; }

 private:
  /// The position is a line in text, an entry of the element in binary data.
  [[noreturn]] void fail(const std::string& reason) const {
    if (header_.format == PlyFormat::Text) failPly(path_, line_, reason);
    failPly(path_, 0, element_->name + " " + std::to_string(entry_) + ": " + reason);
  }
  [[noreturn]] void failCutOff() const {
    const std::string promised = std::to_string(element_->count) + " of \"" + element_->name + "\" are promised";
    fail("the file ends here, but " + promised + "; the file is cut off");
  }

  std::size_t checkedCount(double count) const {
    if (!(count >= 0 && count <= std::numeric_limits<int>::max() && count == std::floor(count))) {
      fail("a list of " + textOf(count) + " entries is not possible; the file is damaged");
    }
    return static_cast<std::size_t>(count);
  }

  void checkCorners(std::size_t count) const {
    if (count > kMostCorners) fail("the polygon has " + std::to_string(count) + " corners; split it, 255 are possible");
  }

  void checkCorner(double corner) const {
    if (corner >= 0 && corner < static_cast<double>(vertices_)) return;
    fail("corner " + textOf(corner) + " is not among the " + std::to_string(vertices_) +
         " vertices, which count from 0; the file is damaged");
  }

  /// Which of red, green, blue and alpha each field of "vertex" is; -1: none, or in bytes, which VTK reads.
  static std::vector<int> colorSlotsOf(const PlyElementHead& element) {
    std::vector<int> slots(element.fields.size(), -1);
    if (element.name != "vertex") return slots;
    constexpr std::string_view kNames[] = {"red", "green", "blue", "alpha"};
    for (std::size_t f = 0; f < slots.size(); ++f) {
      const PlyField& field = element.fields[f];
      if (field.isList || sizeInBytes(field.type) == 1) continue;
      for (int slot = 0; slot < 4; ++slot) {
        if (field.name == kNames[slot] || field.name == "diffuse_" + std::string(kNames[slot])) {
          slots[f] = slot;
        }
      }
    }
    return slots;
  }
  bool colored() const {
    return std::any_of(colorSlots_.begin(), colorSlots_.end(), [](int slot) { return slot >= 0; });
  }
  /// Scales by the type's maximum for integers, by 1 for floats.
  void keepColor(std::size_t field, double value) {
    if (colorSlots_[field] < 0) return;
    const PlyType type = element_->fields[field].type;
    const double full = !isWhole(type) ? 1.0 : sizeInBytes(type) == 2 ? 65535.0 : 4294967295.0;
    const double share = value >= 0.0 ? std::min(value / full, 1.0) : 0.0;  // 0 for NaN, too
    colors_[entry_][static_cast<std::size_t>(colorSlots_[field])] =
        static_cast<std::uint8_t>(std::lround(255.0 * share));
  }

  /// Each corner forms a triangle with the two before it, with alternating winding; -1 ends a strip.
  void readStrips(const PlyElementHead& element) {
    element_ = &element;
    const bool text = header_.format == PlyFormat::Text;
    for (entry_ = 0; entry_ < element.count; ++entry_) {
      if (text) nextLine(bytes_.size());
      for (const PlyField& field : element.fields) {
        const auto next = [&](PlyType type, bool whole) { return text ? nextWord(field, whole) : nextBinary(type); };
        if (!field.isList) {
          next(field.type, false);
          continue;
        }
        const std::size_t count = checkedCount(next(field.countType, isWhole(field.countType)));
        std::vector<std::uint32_t> strip;
        for (std::size_t i = 0; i < count; ++i) {
          const double corner = next(field.type, isWhole(field.type));
          if (field.name != "vertex_indices") continue;
          if (corner < 0) {
            strip.clear();
            continue;
          }
          checkCorner(corner);
          strip.push_back(static_cast<std::uint32_t>(corner));
          const std::size_t n = strip.size();
          if (n < 3) continue;
          const std::size_t odd = n % 2 == 0 ? 1 : 0;
          const std::uint32_t a = strip[n - 3], b = strip[n - 2 + odd], c = strip[n - 1 - odd];
          if (a != b && b != c && a != c) triangles_.insert(triangles_.end(), {a, b, c});
        }
      }
    }
  }

  void nextLine(std::size_t longest = kLongestPlyLine) {
    ++line_;
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string::npos) failCutOff();
    if (end - at_ > longest) {
      fail("the line is longer than " + std::to_string(kLongestPlyLine) + " characters; save the file as binary PLY");
    }
    splitPlyLine(std::string_view(bytes_).substr(at_, end - at_), words_);
    at_ = end + 1;
    word_ = 0;
    if (words_.empty()) fail("the line is empty; delete it");
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

  /// Each entry is one line; VTK ignores further words on it.
  void checkText(const PlyElementHead& element) {
    element_ = &element;
    const std::size_t corners = cornersOf(element);
    for (entry_ = 0; entry_ < element.count; ++entry_) {
      nextLine();
      for (std::size_t f = 0; f < element.fields.size(); ++f) {
        const PlyField& field = element.fields[f];
        if (!field.isList) {
          keepColor(f, nextWord(field, false));
          continue;
        }
        const std::size_t first = word_;
        const std::size_t count = checkedCount(nextWord(field, isWhole(field.countType)));
        if (count > words_.size() - word_) {
          fail("\"" + field.name + "\" is a list of " + std::to_string(count) + ", but " +
               std::to_string(words_.size() - word_) + " words follow; complete the line or correct the count");
        }
        if (f == corners) checkCorners(count);
        for (std::size_t i = 0; i < count; ++i) {
          const double value = nextWord(field, f == corners && isWhole(field.type));
          if (f == corners) checkCorner(value);
        }
        if (f != corners) blank(words_[first].data(), words_[word_ - 1].data() + words_[word_ - 1].size());
      }
    }
    for (std::size_t f = 0; f < element.fields.size(); ++f) {
      const PlyField& field = element.fields[f];
      if (!field.isList || f == corners) continue;
      blank(bytes_.data() + field.begin, bytes_.data() + field.end);
      bytes_.replace(field.begin, 7, "comment");
    }
  }

  void blank(const char* from, const char* to) {
    std::fill(bytes_.begin() + (from - bytes_.data()), bytes_.begin() + (to - bytes_.data()), ' ');
    changed_ = true;
  }

  template <typename T>
  double binaryNumber() const {
    unsigned char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + at_, sizeof(T));
    if (header_.format == PlyFormat::BigEndian) std::reverse(raw, raw + sizeof(T));  // x86 and ARM are little-endian
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

  void checkBinary(const PlyElementHead& element) {
    element_ = &element;
    const std::size_t corners = cornersOf(element);
    for (entry_ = 0; entry_ < element.count; ++entry_) {
      for (std::size_t f = 0; f < element.fields.size(); ++f) {
        const PlyField& field = element.fields[f];
        const std::size_t size = sizeInBytes(field.type);
        const std::size_t count = field.isList ? checkedCount(nextBinary(field.countType)) : 1;
        if (count > (bytes_.size() - at_) / size) {
          if (!field.isList) failCutOff();
          fail("\"" + field.name + "\" is a list of " + std::to_string(count) +
               ", more than the rest of the file holds; " + "the file is damaged or cut off");
        }
        if (f == corners) checkCorners(count);
        if (f == corners) {
          for (std::size_t i = 0; i < count; ++i) checkCorner(nextBinary(field.type));
        } else if (colorSlots_[f] >= 0) {
          keepColor(f, nextBinary(field.type));
        } else {
          at_ += count * size;
        }
      }
    }
    for (const PlyField& field : element.fields) {
      if (element.name != "face" || field.name != "texcoord") continue;
      bytes_[bytes_.rfind("texcoord", field.end)] = 'T';  // a name that VTK does not look for
      changed_ = true;
    }
  }

  const std::string& path_;
  std::string& bytes_;
  const PlyHeader& header_;
  const PlyElementHead* element_ = nullptr;
  std::vector<std::string_view> words_;
  std::vector<int> colorSlots_;  // by field of the element being checked
  std::vector<std::array<std::uint8_t, 4>> colors_;
  std::vector<std::uint32_t> triangles_;
  std::size_t at_, line_, entry_ = 0, word_ = 0, vertices_ = 0;
  bool changed_ = false;
};

/// Replaces a comment by several short ones of the same total length.
void shorten(std::string& bytes, std::size_t begin, std::size_t end) {
  constexpr std::size_t kPart = 2000;
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(begin), bytes.begin() + static_cast<std::ptrdiff_t>(end), ' ');
  bytes.replace(begin, 7, "comment");
  for (std::size_t at = begin + kPart; at + 8 <= end; at += kPart) bytes.replace(at, 8, "\ncomment");
}

/// Old Macintosh files end lines with carriage returns: replaces them by line feeds, in the header and in a text body.
/// Returns whether there were any.
bool endLinesByFeeds(std::string& bytes) {
  if (bytes.compare(0, 4, "ply\r") != 0 || bytes.compare(0, 5, "ply\r\n") == 0) return false;
  const std::string last = "\rend_header\r";
  const std::size_t end = bytes.find(last);
  const bool text = bytes.find("\rformat ascii") < end;
  const std::size_t stop = text || end == std::string::npos ? bytes.size() : end + last.size();
  std::replace(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(stop), '\r', '\n');
  return true;
}

/// Replaces carriage returns within a line by spaces, which they mean here; VTK from 9.6 on ends the line there.
/// Returns whether there were any.
bool spaceOutReturns(std::string& bytes, std::size_t end) {
  bool any = false;
  for (std::size_t at = bytes.find('\r'); at < end; at = bytes.find('\r', at + 1)) {
    if (at + 1 < bytes.size() && bytes[at + 1] == '\n') continue;
    bytes[at] = ' ';
    any = true;
  }
  return any;
}

}  // namespace

PlyCheck checkPly(const std::string& path) {
  std::string bytes = readWholeFile(path);
  const bool respelled = endLinesByFeeds(bytes);
  const PlyHeader header = readPlyHeader(path, bytes);
  const bool spaced = spaceOutReturns(bytes, header.format == PlyFormat::Text ? bytes.size() : header.body);
  bool changed = respelled || spaced || !header.longComments.empty();
  for (const auto& [begin, end] : header.longComments) shorten(bytes, begin, end);
  if (header.format == PlyFormat::Text && bytes.back() != '\n') {
    bytes += '\n';
    changed = true;
  }
  BodyCheck body(path, bytes, header);
  body.check();
  PlyCheck result;
  result.colors = body.takeColors();
  result.triangles = body.takeTriangles();
  if (changed || body.changed()) result.text = std::move(bytes);
  return result;
}

}  // namespace boxprobe
