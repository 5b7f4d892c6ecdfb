#include "filters/io/obj/mtl_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "filters/core/base/file_limits.h"
#include "filters/core/base/one_line.h"
#include "filters/core/base/printable_text.h"
#include "filters/io/files/read_file.h"
#include "filters/io/obj/obj_text.h"

namespace boxprobe {

namespace {

const std::set<std::string>& colorKeys() {
  static const std::set<std::string> keys = {"kd", "ks", "ke", "tf", "ka"};
  return keys;
}
const std::set<std::string>& numberKeys() {
  static const std::set<std::string> keys = {"ns", "d",  "tr", "ni",  "illum", "pr",
                                             "pm", "ps", "pc", "pcr", "aniso", "anisor"};
  return keys;
}
/// By the names that programs write.
const std::map<std::string, std::string>& mapKeys() {
  static const std::map<std::string, std::string> keys = {
      {"map_kd", "map_kd"},   {"map_ks", "map_ks"},   {"map_ke", "map_ke"},     {"map_emissive", "map_ke"},
      {"map_ns", "map_ns"},   {"map_d", "map_d"},     {"map_opacity", "map_d"}, {"map_bump", "map_bump"},
      {"bump", "map_bump"},   {"norm", "norm"},       {"map_norm", "norm"},     {"map_kn", "norm"},
      {"map_pr", "map_pr"},   {"map_pm", "map_pm"},   {"map_ps", "map_ps"},     {"map_pc", "map_pc"},
      {"map_pcr", "map_pcr"}, {"map_rma", "map_rma"}, {"map_orm", "map_orm"},   {"map_ao", "map_ao"}};
  return keys;
}

class MtlReader {
 public:
  explicit MtlReader(const std::string& path)
      : path_(path),
        name_(std::filesystem::path(path).filename().string()),
        bytes_(utf8Text(readWholeFile(path))),
        lines_(bytes_) {}

  MtlFile read() {
    for (std::string_view line; lines_.next(line);) {
      if (line.find('\0') != std::string_view::npos) {
        warn("is not text from here on; save it as MTL again");
        break;
      }
      takeLine(line);
    }
    if (!leftOut_.empty()) {
      std::string text;
      for (const std::string& key : leftOut_) text += (text.empty() ? "" : ", ") + key;
      file_.warnings.push_back(
          oneLine("has statements in " + printable(name_) + " that are not used as written: " + text));
    }
    return std::move(file_);
  }

 private:
  void warn(const std::string& reason) {
    constexpr std::size_t kMost = 20;
    if (file_.warnings.size() > kMost) return;
    if (file_.warnings.size() == kMost) {
      file_.warnings.push_back(printable(name_) + " has further lines that are not understood");
      return;
    }
    file_.warnings.push_back(oneLine(printable(name_) + ":" + std::to_string(lines_.number()) + ": " + reason));
  }
  void leaveOut(std::string_view what) {
    constexpr std::size_t kMost = 24, kLongest = 40;
    if (leftOut_.size() < kMost) leftOut_.insert(printable(std::string(what.substr(0, kLongest))));
  }

  void takeLine(std::string_view line) {
    const std::string_view written = nextObjWord(line);
    if (written.empty() || written.front() == '#') return;
    const std::string key = lowerText(written);
    if (key == "newmtl") {
      startMaterial(unquoted(line));
      return;
    }
    if (material_ == nullptr) {
      leaveOut(std::string(written) + " before the first newmtl");
      return;
    }
    const auto map = mapKeys().find(key);
    if (map != mapKeys().end()) {
      takeMap(map->second, line);
    } else if (colorKeys().count(key) > 0) {
      takeColor(key, written, line);
    } else if (numberKeys().count(key) > 0) {
      takeNumber(key, written, line);
    } else {
      leaveOut(written);
    }
  }

  void startMaterial(const std::string& name) {
    if (!names_.insert(name).second) {
      warn("the material " + printable(name) + " is defined again; the first one counts");
      unused_ = MtlMaterial();
      material_ = &unused_;
      return;
    }
    file_.materials.emplace_back();
    material_ = &file_.materials.back();
    material_->name = name;
  }

  bool readNumber(std::string_view word, double& value, std::string_view key) {
    if (readObjNumber(word, value) && std::isfinite(value)) return true;
    warn("\"" + printable(std::string(word.substr(0, 40))) + "\" is not a number; this " +
         printable(std::string(key.substr(0, 40))) + " is left out");
    return false;
  }

  /// "Kd R [G B]" or "Kd xyz X [Y Z]", CIE values.
  void takeColor(const std::string& key, std::string_view written, std::string_view line) {
    std::string_view word = nextObjValue(line);
    const std::string kind = lowerText(word);
    if (kind == "spectral") {
      leaveOut(std::string(written) + " spectral");
      return;
    }
    if (kind == "xyz") word = nextObjValue(line);
    glm::dvec3 color(0.0);
    for (int i = 0; i < 3; ++i) {
      if (word.empty() && i > 0) {
        color[i] = color[0];  // one number is a grey
        continue;
      }
      if (!readNumber(word, color[i], written)) return;
      word = nextObjValue(line);
    }
    if (kind == "xyz") color = linearOfXyz(color);
    if (key != "ke" && std::max({color.r, color.g, color.b}) > 1.0) {
      if (key != "ka") leaveOut(std::string(written) + " above 1 (taken as 1)");
      color = glm::dvec3(std::min(color.r, 1.0), std::min(color.g, 1.0), std::min(color.b, 1.0));
    }
    for (int i = 0; i < 3; ++i) color[i] = std::clamp(color[i], 0.0, limits::kNumber);
    material_->colors[key] = color;
  }

  /// IEC 61966-2-1.
  static glm::dvec3 linearOfXyz(const glm::dvec3& c) {
    return {3.2406 * c.x - 1.5372 * c.y - 0.4986 * c.z, -0.9689 * c.x + 1.8758 * c.y + 0.0415 * c.z,
            0.0557 * c.x - 0.2040 * c.y + 1.0570 * c.z};
  }

  void takeNumber(const std::string& key, std::string_view written, std::string_view line) {
    std::string_view word = nextObjValue(line);
    if (key == "d" && lowerText(word) == "-halo") {
      leaveOut("d -halo");
      word = nextObjValue(line);
    }
    double value = 0.0;
    if (readNumber(word, value, written)) material_->numbers[key] = value;
  }

  void takeMap(const std::string& key, std::string_view line) {
    MtlMap map;
    map.file = path_;
    while (takeOption(map, key, line)) {
    }
    map.name = unquoted(line);
    if (map.name.empty()) {
      warn("names no picture; complete the line");
      return;
    }
    if (map.name == "." || lowerText(map.name) == "none") return;
    material_->maps[key] = map;
  }

  /// Takes an option with its values from the line; false if the line starts with no option.
  bool takeOption(MtlMap& map, const std::string& key, std::string_view& line) {
    std::string_view rest = line;
    const std::string option = lowerText(nextObjWord(rest));
    if (option.size() < 2 || option.front() != '-') return false;
    if (option == "-s" || option == "-o" || option == "-t") {
      double values[3] = {0.0, option == "-s" ? 1.0 : 0.0, option == "-s" ? 1.0 : 0.0};
      takeTriple(rest, values);
      if (option == "-s") map.scale = {values[0], values[1]};
      if (option == "-o") map.offset = {values[0], values[1]};
      if (option == "-t" && (values[0] != 0.0 || values[1] != 0.0)) leaveOut("-t (turbulence)");
    } else if (option == "-bm") {
      takeOptionNumber(rest, map.bump);
    } else if (option == "-mm") {
      takeOptionNumber(rest, map.base);
      takeOptionNumber(rest, map.gain);
    } else if (option == "-clamp") {
      map.clamp = lowerText(nextObjWord(rest)) == "on";
    } else if (option == "-imfchan") {
      const std::string channel = lowerText(nextObjWord(rest));
      map.channel = channel.empty() ? '\0' : channel.front();
    } else if (option == "-blendu" || option == "-blendv" || option == "-texres") {
      nextObjWord(rest);  // how a renderer filters
    } else if (option == "-colorspace") {
      const std::string space = lowerText(nextObjWord(rest));
      const bool color = key == "map_kd" || key == "map_ks" || key == "map_ke" || key == "map_ps";
      if (color != (space == "srgb")) leaveOut(option + " " + space + " of " + key);
    } else if (option == "-boost" || option == "-cc" || option == "-type") {
      leaveOut(option + " " + std::string(nextObjWord(rest)));
    } else {
      return false;  // a file name may start so
    }
    line = rest;
    return true;
  }

  /// The last two may be missing.
  void takeTriple(std::string_view& rest, double* values) {
    for (int i = 0; i < 3; ++i) {
      std::string_view after = rest;
      double value = 0.0;
      const std::string_view word = nextObjWord(after);
      // What is left must still hold the file's name, which may be a number.
      if (!readObjNumber(word, value) || !std::isfinite(value) || trimmedText(after).empty()) {
        if (i == 0) warn("an option has no number; it is left out");
        return;
      }
      values[i] = std::clamp(value, -kLargestOption, kLargestOption);
      rest = after;
    }
  }
  void takeOptionNumber(std::string_view& rest, double& to) {
    double value = 0.0;
    if (readNumber(nextObjWord(rest), value, "option")) to = std::clamp(value, -kLargestOption, kLargestOption);
  }

  static constexpr double kLargestOption = 1e6;

  const std::string& path_;
  const std::string name_;
  const std::string bytes_;
  ObjLines lines_;
  MtlFile file_;
  MtlMaterial unused_;
  MtlMaterial* material_ = nullptr;
  std::set<std::string> names_, leftOut_;
};

}  // namespace

const glm::dvec3* MtlMaterial::color(const char* key) const {
  const auto found = colors.find(key);
  return found == colors.end() ? nullptr : &found->second;
}

std::optional<double> MtlMaterial::number(const char* key) const {
  const auto found = numbers.find(key);
  return found == numbers.end() ? std::nullopt : std::optional<double>(found->second);
}

const MtlMap* MtlMaterial::map(const char* key) const {
  const auto found = maps.find(key);
  return found == maps.end() ? nullptr : &found->second;
}

MtlFile readMtlFile(const std::string& path) {
  return MtlReader(path).read();
}

}  // namespace boxprobe
