// The format ("Radiance File Formats", Ward; color.c): lines of text up to an empty one; a line with the size and the
// order of the axes; then scan lines. A line of new run lengths is 2, 2, the length in two bytes, then four channels of
// runs: a count above 128 and a value to repeat, or a count and that many values. Any other line is pixels of four
// bytes, where 1, 1, 1, n repeats the pixel before n times, and each further repetition in turn counts 256 times as
// much.
#include "filters/io/image/radiance_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <locale>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/image/color_primaries.h"
#include "filters/io/image/image_detail.h"

namespace boxprobe {

namespace {

/// "-Y 512 +X 1024": scan lines from the top, each from the left.
struct RadianceAxes {
  bool columnsFirst = false;  ///< scan lines are columns
  bool fromBottom = false, fromRight = false;
  long long width = 0, height = 0;
};

std::optional<RadianceAxes> axesOf(std::string_view line) {
  RadianceAxes axes;
  char seen = 0;
  for (int part = 0; part < 2; ++part) {
    const std::size_t start = line.find_first_not_of(' ');
    if (start == std::string_view::npos || start + 2 >= line.size()) return {};
    const char sign = line[start], axis = line[start + 1];
    if ((sign != '+' && sign != '-') || (axis != 'X' && axis != 'Y') || axis == seen) return {};
    line.remove_prefix(start + 2);
    const std::size_t digits = line.find_first_not_of(' ');
    if (digits == std::string_view::npos || digits == 0) return {};
    line.remove_prefix(digits);
    long long size = 0;
    const auto read = std::from_chars(line.data(), line.data() + line.size(), size);
    if (read.ec != std::errc() || size < 0) return {};
    line.remove_prefix(static_cast<std::size_t>(read.ptr - line.data()));
    (axis == 'X' ? axes.width : axes.height) = size;
    if (axis == 'X') axes.fromRight = sign == '-';
    if (axis == 'Y') axes.fromBottom = sign == '+';
    if (part == 0) axes.columnsFirst = axis == 'X';
    seen = axis;
  }
  if (line.find_first_not_of(' ') != std::string_view::npos) return {};
  return axes;
}

class RadianceReader {
 public:
  RadianceReader(const std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  RadiancePicture read() {
    readHeader();
    checkImageSize(name_, axes_.width, axes_.height);
    readBody();
    return picture();
  }

 private:
  [[noreturn]] void damaged(const std::string& what) const {
    throw InputError(oneLine(name_ + ": is damaged (" + what + "); save it again"));
  }

  /// Without its end; nothing at the end of the file.
  std::optional<std::string_view> nextLine() {
    if (at_ >= bytes_.size()) return {};
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string::npos) return {};
    std::string_view line(bytes_.data() + at_, end - at_);
    at_ = end + 1;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  void readHeader() {
    if (bytes_.compare(0, 2, "#?") != 0) {
      throw InputError(name_ + ": is not a Radiance HDR picture; save it as .exr or .hdr");
    }
    nextLine();
    while (const auto line = nextLine()) {
      if (const auto axes = axesOf(*line)) {
        axes_ = *axes;
        return;
      }
      // After the empty line only the size can follow.
      if (headerEnded_) damaged("\"" + std::string(line->substr(0, 40)) + "\" is no size such as -Y 512 +X 1024");
      if (line->empty()) headerEnded_ = true;
      readVariable(*line);
    }
    damaged("it ends in its header");
  }

  void readVariable(std::string_view line) {
    const std::size_t equals = line.find('=');
    if (line.empty() || line[0] == '#' || equals == std::string_view::npos) return;
    std::string_view key = line.substr(0, equals);
    while (!key.empty() && (key.back() == ' ' || key.back() == '\t')) key.remove_suffix(1);
    const std::string value(line.substr(equals + 1));
    if (key == "FORMAT") return readFormat(value);
    if (key == "EXPOSURE") {
      const auto numbers = numbersOf<1>(value);
      return multiply("EXPOSURE", value, numbers ? glm::dvec3((*numbers)[0]) : glm::dvec3(0.0));
    }
    if (key == "COLORCORR") {
      const auto n = numbersOf<3>(value);
      return multiply("COLORCORR", value, n ? glm::dvec3((*n)[0], (*n)[1], (*n)[2]) : glm::dvec3(0.0));
    }
    if (key == "PRIMARIES") {
      const auto n = numbersOf<8>(value);
      const bool none = n && std::all_of(n->begin(), n->end(), [](double v) { return v == 0.0; });
      if (none) return;
      if (n)
        primaries_ = ColorPrimaries{{(*n)[0], (*n)[1]}, {(*n)[2], (*n)[3]}, {(*n)[4], (*n)[5]}, {(*n)[6], (*n)[7]}};
      if (!n || !rec709From(*primaries_)) {
        primaries_.reset();
        notFollowed("PRIMARIES", value, "eight chromaticities that span colours are needed");
      }
      return;
    }
    if (key == "GAMMA") {
      const auto numbers = numbersOf<1>(value);
      if (!numbers || (*numbers)[0] != 1.0) notFollowed("GAMMA", value, "its values are taken as linear");
    }
  }

  void readFormat(const std::string& value) {
    const std::size_t start = value.find_first_not_of(" \t");
    const std::string format =
        start == std::string::npos ? "" : value.substr(start, value.find_last_not_of(" \t") + 1 - start);
    if (format == "32-bit_rle_xyze") {
      xyz_ = true;
    } else if (format != "32-bit_rle_rgbe") {
      throw InputError(oneLine(name_ + ": FORMAT=" + format + " is not read; save it as 32-bit_rle_rgbe or as .exr"));
    }
  }

  template <std::size_t Count>
  static std::optional<std::array<double, Count>> numbersOf(const std::string& text) {
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    std::array<double, Count> numbers{};
    for (double& number : numbers) {
      if (!(in >> number) || !std::isfinite(number)) return {};
    }
    return numbers;
  }

  void notFollowed(const std::string& key, const std::string& value, const std::string& why) {
    remarks_.push_back(oneLine(key + "=" + value.substr(0, 80) + " is not followed: " + why));
  }

  /// What the values were multiplied by; several lines of a kind multiply.
  void multiply(const std::string& key, const std::string& value, const glm::dvec3& factor) {
    const glm::dvec3 all = exposure_ * factor;
    for (int c = 0; c < 3; ++c) {
      if (!(all[c] > 0.0) || !std::isfinite(all[c]) || !std::isfinite(1.0 / all[c])) {
        return notFollowed(key, value, "positive numbers are needed");
      }
    }
    exposure_ = all;
  }

  int nextByte() { return at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_++]) : -1; }

  [[noreturn]] void endsEarly(std::size_t line) const {
    damaged("it ends in scan line " + std::to_string(line + 1) + " of " +
            std::to_string(axes_.columnsFirst ? axes_.width : axes_.height));
  }

  /// A file of four bytes per pixel may be without runs, and have pixels that look like the start of some: it is read
  /// as runs only where these end with the file.
  void readBody() {
    const std::size_t body = at_, plain = 4 * static_cast<std::size_t>(axes_.width * axes_.height);
    const bool maybePlain = bytes_.size() - body == plain;
    try {
      readScanLines();
      if (!maybePlain || at_ == bytes_.size()) return;
    } catch (const InputError&) {
      if (!maybePlain) throw;
    }
    rgbe_.assign(bytes_.begin() + static_cast<std::ptrdiff_t>(body), bytes_.end());
  }

  void readScanLines() {
    const auto lines = static_cast<std::size_t>(axes_.columnsFirst ? axes_.width : axes_.height);
    length_ = static_cast<std::size_t>(axes_.columnsFirst ? axes_.height : axes_.width);
    constexpr std::size_t kMostFromAByte = 64;  // of new run lengths: 127 values in 2 bytes; others may grow
    rgbe_.reserve(std::min(4 * lines * length_, kMostFromAByte * bytes_.size()));
    for (std::size_t line = 0; line < lines; ++line) {
      if (bytes_.size() - std::min(at_, bytes_.size()) < 4) endsEarly(line);
      const auto* head = reinterpret_cast<const unsigned char*>(bytes_.data() + at_);
      const std::size_t claimed = 256U * head[2] + head[3];
      constexpr std::size_t kShortestNew = 8, kLongestNew = 0x7fff;
      const bool runs =
          length_ >= kShortestNew && length_ <= kLongestNew && head[0] == 2 && head[1] == 2 && head[2] < 128;
      if (runs && claimed != length_) {
        damaged("scan line " + std::to_string(line + 1) + " has " + std::to_string(claimed) + " pixels in place of " +
                std::to_string(length_));
      }
      if (runs) {
        at_ += 4;
        readRuns(line);
      } else {
        readPixels(line);
      }
    }
  }

  void readRuns(std::size_t line) {
    const std::size_t start = rgbe_.size();
    rgbe_.resize(start + 4 * length_);
    for (std::size_t channel = 0; channel < 4; ++channel) {
      for (std::size_t done = 0; done < length_;) {
        const int head = nextByte();
        if (head < 0) endsEarly(line);
        const bool repeated = head > 128;
        const auto count = static_cast<std::size_t>(repeated ? head - 128 : head);
        if (count == 0 || count > length_ - done) {
          damaged("the runs of scan line " + std::to_string(line + 1) + " do not fill it");
        }
        int value = repeated ? nextByte() : 0;
        for (std::size_t i = 0; i < count; ++i, ++done) {
          if (!repeated) value = nextByte();
          if (value < 0) endsEarly(line);
          rgbe_[start + 4 * done + channel] = static_cast<std::uint8_t>(value);
        }
      }
    }
  }

  void readPixels(std::size_t line) {
    int shift = 0;
    for (std::size_t done = 0; done < length_;) {
      if (bytes_.size() - std::min(at_, bytes_.size()) < 4) endsEarly(line);
      std::array<std::uint8_t, 4> pixel{};
      for (std::uint8_t& byte : pixel) byte = static_cast<std::uint8_t>(nextByte());
      if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
        rgbe_.insert(rgbe_.end(), pixel.begin(), pixel.end());
        ++done;
        shift = 0;
        continue;
      }
      constexpr int kLargestShift = 24;  // no line is that long
      const std::size_t count = shift > kLargestShift ? length_ + 1 : static_cast<std::size_t>(pixel[3]) << shift;
      if (rgbe_.empty() || count > length_ - done) {
        damaged("the runs of scan line " + std::to_string(line + 1) + " do not fit it");
      }
      const std::array<std::uint8_t, 4> last = {rgbe_[rgbe_.size() - 4], rgbe_[rgbe_.size() - 3],
                                                rgbe_[rgbe_.size() - 2], rgbe_[rgbe_.size() - 1]};
      for (std::size_t i = 0; i < count; ++i) rgbe_.insert(rgbe_.end(), last.begin(), last.end());
      done += count;
      shift += 8;
    }
  }

  /// Where the pixel of a scan line stands in rows from the top.
  std::size_t placeOf(std::size_t line, std::size_t along) const {
    const auto width = static_cast<std::size_t>(axes_.width), height = static_cast<std::size_t>(axes_.height);
    const std::size_t x = axes_.columnsFirst ? line : along, y = axes_.columnsFirst ? along : line;
    return (axes_.fromBottom ? height - 1 - y : y) * width + (axes_.fromRight ? width - 1 - x : x);
  }

  RadiancePicture picture() {
    RadiancePicture result;
    ImageRgbaF& image = result.image;
    image.width = static_cast<int>(axes_.width);
    image.height = static_cast<int>(axes_.height);
    image.pixels.resize(rgbe_.size());
    glm::dmat3 toRec709(1.0);
    if (xyz_) toRec709 = rec709FromXyz();
    if (xyz_ && primaries_) remarks_.push_back("PRIMARIES is not followed: the values are XYZ");
    if (!xyz_ && primaries_) toRec709 = *rec709From(*primaries_);
    const bool asItIs = toRec709 == glm::dmat3(1.0) && exposure_ == glm::dvec3(1.0);
    // Powers of two are exact: a value is its mantissa / 256 times 2^(exponent - 128).
    std::array<float, 256> unit{};
    for (int exponent = 1; exponent < 256; ++exponent) {
      unit[static_cast<std::size_t>(exponent)] = std::ldexp(1.0f, exponent - 136);
    }
    const std::size_t pixels = rgbe_.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i) {
      const std::uint8_t* from = &rgbe_[4 * i];
      float* to = &image.pixels[4 * placeOf(i / length_, i % length_)];
      for (int c = 0; c < 3; ++c) to[c] = static_cast<float>(from[c]) * unit[from[3]];
      to[3] = 1.0f;
      if (asItIs) continue;
      const glm::dvec3 light = toRec709 * (glm::dvec3(to[0], to[1], to[2]) / exposure_);
      for (int c = 0; c < 3; ++c) to[c] = static_cast<float>(light[c]);
    }
    result.remarks = std::move(remarks_);
    return result;
  }

  const std::string& bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
  RadianceAxes axes_;
  bool headerEnded_ = false, xyz_ = false;
  glm::dvec3 exposure_{1.0};
  std::optional<ColorPrimaries> primaries_;
  std::vector<std::uint8_t> rgbe_;  ///< in the file's order
  std::size_t length_ = 0;          ///< pixels of a scan line
  std::vector<std::string> remarks_;
};

}  // namespace

RadiancePicture decodeRadiance(const std::string& bytes, const std::string& name) {
  return RadianceReader(bytes, name).read();
}

}  // namespace boxprobe
