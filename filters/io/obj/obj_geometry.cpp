#include "filters/io/obj/obj_geometry.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <unordered_map>

#include "filters/core/base/file_limits.h"
#include "filters/core/base/one_line.h"
#include "filters/core/base/printable_text.h"
#include "filters/io/files/decimal_comma.h"
#include "filters/io/files/read_file.h"
#include "filters/io/mesh/polygon_triangles.h"
#include "filters/io/obj/obj_text.h"

namespace boxprobe {

namespace {

/// Indices of names in the order of their first use.
class Names {
 public:
  explicit Names(std::vector<std::string>& names) : names_(names) { at({}); }
  std::uint32_t at(const std::string& name) {
    const auto [entry, isNew] = indices_.emplace(name, static_cast<std::uint32_t>(names_.size()));
    if (isNew) names_.push_back(name);
    return entry->second;
  }

 private:
  std::vector<std::string>& names_;
  std::unordered_map<std::string, std::uint32_t> indices_;
};

class GeometryReader {
 public:
  GeometryReader(const std::string& path, const LoadProgress& progress)
      : path_(path),
        progress_(progress),
        bytes_(utf8Text(readWholeFile(path))),
        lines_(bytes_),
        objects_(result_.objects),
        groups_(result_.groups),
        materials_(result_.materials) {}

  ObjGeometry read() {
    std::size_t count = 0;
    for (std::string_view line; lines_.next(line);) {
      if (line.find('\0') != std::string_view::npos) fail("is not text; save it as OBJ again");
      takeLine(line);
      constexpr std::size_t kBetween = 1 << 14;
      if (++count % kBetween == 0 && progress_ && !progress_(0.5 * lines_.done())) {
        throw LoadCancelled(path_ + ": loading was cancelled");
      }
    }
    if (faceLines_ == 0) {
      throw InputError(path_ + (result_.positions.empty() ? ": has no faces; is it an OBJ file?"
                                                          : ": has no faces; points and lines are not drawn"));
    }
    checkCorners();
    finishColors();
    warn();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { failAt(lines_.number(), reason); }
  [[noreturn]] void failAt(std::size_t line, const std::string& reason) const {
    throw InputError(oneLine(path_ + ":" + std::to_string(line) + ": " + reason));
  }

  void takeLine(std::string_view line) {
    const std::string_view key = nextObjWord(line);
    if (key.empty() || key.front() == '#') return;
    if (key == "v") {
      takeVertex(line);
    } else if (key == "vt") {
      double uv[3];
      takeNumbers(line, 1, 3, uv);
      result_.uvs.emplace_back(uv[0], uv[1]);
    } else if (key == "vn") {
      double n[3];
      takeNumbers(line, 3, 3, n);
      result_.normals.emplace_back(n[0], n[1], n[2]);
    } else if (key == "f" || key == "fo") {
      takeFace(line);
    } else {
      takeState(lowerText(key), line);
    }
  }

  void takeState(const std::string& key, std::string_view line) {
    if (key == "usemtl") {
      face_.material = materials_.at(unquoted(line));
    } else if (key == "o") {
      face_.object = objects_.at(unquoted(line));
    } else if (key == "g") {
      face_.group = groups_.at(unquoted(line));
    } else if (key == "s") {
      takeSmoothing(nextObjValue(line));
    } else if (key == "mtllib") {
      if (result_.libraries.size() == limits::kEntries) {
        fail("more than " + std::to_string(limits::kEntries) + " lines name material files; leave some out");
      }
      result_.libraries.emplace_back(lines_.number(), std::string(trimmedText(line)));
    } else if (leftOut_.size() < kMostKeys || leftOut_.count(key) > 0) {
      ++leftOut_[key];
    }
  }

  void takeSmoothing(std::string_view word) {
    int group = 0;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), group);
    face_.smoothing = result.ec == std::errc() ? std::clamp(group, 0, kMostGroups) : lowerText(word) == "on" ? 1 : 0;
  }

  /// Reads up to `most` numbers and returns their count; the missing ones are 0.
  int takeNumbers(std::string_view line, int least, int most, double* numbers) {
    int count = 0;
    for (; count < most; ++count) {
      const std::string_view word = nextObjValue(line);
      if (word.empty()) break;
      if (!readObjNumber(word, numbers[count])) {
        const auto comma = decimalCommaNumber(word);
        if (!comma) fail("\"" + std::string(word.substr(0, 40)) + "\" is not a number; correct it");
        numbers[count] = *comma;
        commas_ = true;
      }
    }
    if (count < least) {
      fail("the line has " + std::to_string(count) + " numbers, too few; " + std::to_string(least) + " are needed");
    }
    std::fill(numbers + count, numbers + most, 0.0);
    return count;
  }

  /// "v X Y Z", with a weight W that only free-form curves use, or with a colour R G B, an extension of many programs.
  void takeVertex(std::string_view line) {
    double numbers[7];
    const int count = takeNumbers(line, 3, 7, numbers);
    result_.positions.emplace_back(numbers[0], numbers[1], numbers[2]);
    if (count < 6 && result_.colors.empty()) return;
    result_.colors.resize(result_.positions.size(), glm::vec3(-1.0f));
    if (count < 6) return;
    glm::vec3& color = result_.colors.back();
    for (int i = 0; i < 3; ++i) {
      const double value = numbers[3 + i] >= 0.0 ? numbers[3 + i] : 0.0;  // 0 for NaN, too
      color[i] = static_cast<float>(std::min(value, 255.0));
      brightest_ = std::max(brightest_, color[i]);
    }
    if (count == 7 && numbers[6] != 1.0) colorAlpha_ = true;
  }

  void takeFace(std::string_view line) {
    ++faceLines_;
    face_.first = result_.corners.size();
    for (std::string_view word = nextObjValue(line); !word.empty(); word = nextObjValue(line)) takeCorner(word);
    const std::size_t count = result_.corners.size() - face_.first;
    if (count > limits::kPolygonCorners) {
      fail("the polygon has " + std::to_string(count) + " corners; split it, " +
           std::to_string(limits::kPolygonCorners) + " are possible");
    }
    if (count < 3) {
      ++leftOut_["f with fewer than three corners"];
      result_.corners.resize(face_.first);
      return;
    }
    face_.count = static_cast<std::uint32_t>(count);
    result_.faces.push_back(face_);
    faceLine_.push_back(static_cast<std::uint32_t>(lines_.number()));
  }

  /// "12", "12/3", "12//4" or "12/3/4"; negative numbers count back from the last entry so far.
  void takeCorner(std::string_view word) {
    ObjCorner corner;
    const std::size_t counts[3] = {result_.positions.size(), result_.uvs.size(), result_.normals.size()};
    std::uint32_t* parts[3] = {&corner.position, &corner.uv, &corner.normal};
    const char *at = word.data(), *end = at + word.size();
    for (int part = 0; part < 3 && at < end; ++part) {
      if (*at == '/') {
        if (part == 0) failCorner(word);
        ++at;
        continue;
      }
      long long index = 0;
      const auto result = std::from_chars(at, end, index);
      if (result.ec == std::errc::invalid_argument || index == 0) failCorner(word);
      const auto count = static_cast<long long>(counts[part]);
      if (result.ec != std::errc() || index < -count || index >= static_cast<long long>(kNoObjEntry)) {
        failIndex(lines_.number(), word, index, count);
      }
      *parts[part] = static_cast<std::uint32_t>(index < 0 ? count + index : index - 1);
      at = result.ptr;
      if (at < end && *at == '/') ++at;
    }
    if (at != end) failCorner(word);
    result_.corners.push_back(corner);
  }

  [[noreturn]] void failCorner(std::string_view word) const {
    fail("\"" + std::string(word.substr(0, 40)) + "\" is not a corner; indices start from 1");
  }
  [[noreturn]] void failIndex(std::size_t line, std::string_view word, long long index, long long count) const {
    failAt(line, "\"" + std::string(word.substr(0, 40)) + "\" refers to entry " + std::to_string(index) +
                     ", but there are " + std::to_string(count) + "; the file is damaged");
  }

  /// Vertices may stand behind the faces that use them. Some programs write indices of lists that they leave out.
  void checkCorners() {
    if (result_.uvs.empty()) leaveOutIndices(&ObjCorner::uv, "texture coordinates");
    if (result_.normals.empty()) leaveOutIndices(&ObjCorner::normal, "normals");
    for (std::size_t f = 0; f < result_.faces.size(); ++f) {
      const ObjFace& face = result_.faces[f];
      for (std::size_t c = face.first; c < face.first + face.count; ++c) {
        const ObjCorner& corner = result_.corners[c];
        checkIndex(corner.position, result_.positions.size(), faceLine_[f]);
        if (corner.uv != kNoObjEntry) checkIndex(corner.uv, result_.uvs.size(), faceLine_[f]);
        if (corner.normal != kNoObjEntry) checkIndex(corner.normal, result_.normals.size(), faceLine_[f]);
      }
    }
  }
  void leaveOutIndices(std::uint32_t ObjCorner::*part, const char* what) {
    bool any = false;
    for (ObjCorner& corner : result_.corners) {
      any = any || corner.*part != kNoObjEntry;
      corner.*part = kNoObjEntry;
    }
    if (any) result_.warnings.push_back(std::string("refers to ") + what + ", of which it has none");
  }
  void checkIndex(std::uint32_t index, std::size_t count, std::size_t line) const {
    if (index < count) return;
    failIndex(line, std::to_string(index + 1ull), index + 1ll, static_cast<long long>(count));
  }

  /// Some programs write colours as bytes.
  void finishColors() {
    if (result_.colors.empty()) return;
    result_.colors.resize(result_.positions.size(), glm::vec3(-1.0f));
    if (brightest_ <= 1.0f) return;
    result_.warnings.emplace_back("has vertex colours above 1, which are read as 0 to 255");
    for (glm::vec3& color : result_.colors) {
      if (color.r >= 0.0f) color /= 255.0f;
    }
  }

  void warn() {
    if (commas_) result_.warnings.emplace_back(kDecimalCommas);
    if (colorAlpha_) result_.warnings.emplace_back("has an alpha in its vertex colours, which is left out");
    if (leftOut_.empty()) return;
    std::string text;
    for (const auto& [key, count] : leftOut_) {
      text += (text.empty() ? "" : ", ") + printable(key.substr(0, 32)) + " (" + std::to_string(count) + ")";
    }
    result_.warnings.push_back(oneLine("has statements that are not drawn: " + text));
  }

  static constexpr std::size_t kMostKeys = 16;
  static constexpr int kMostGroups = 1 << 29;

  const std::string& path_;
  const LoadProgress& progress_;
  const std::string bytes_;
  ObjLines lines_;
  ObjGeometry result_;
  Names objects_, groups_, materials_;
  ObjFace face_;  ///< with what holds from here on
  std::vector<std::uint32_t> faceLine_;
  std::map<std::string, std::size_t> leftOut_;
  std::size_t faceLines_ = 0;
  float brightest_ = 0.0f;
  bool colorAlpha_ = false, commas_ = false;
};

}  // namespace

ObjGeometry readObjGeometry(const std::string& path, const LoadProgress& progress) {
  return GeometryReader(path, progress).read();
}

}  // namespace boxprobe
