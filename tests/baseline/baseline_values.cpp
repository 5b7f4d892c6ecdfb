#include "tests/baseline/baseline_values.h"

#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfIntAttribute.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfTiledInputPart.h>
#include <ImfVecAttribute.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "filters/io/image/image_file.h"
#include "tests/cli/program.h"

namespace boxprobe::test {

namespace fs = std::filesystem;
using Json = BaselineJson;

namespace {

constexpr const char* kMeans = "thousandths";  // of the picture's mean: means of 4 x 3 pixels, red, green, blue

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

double rounded(double value, int digits) {
  if (!std::isfinite(value) || value == 0.0) return 0.0;
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return std::strtod(text, nullptr);
}

/// Those that say how long something took, on what, or where it lies; light along traced paths, which end elsewhere on
/// another processor.
bool leftOut(const std::string& key) {
  static const std::set<std::string> names = {"times",  "memoryBytes", "gl",       "renderer",  "software",
                                              "writer", "path",        "checksum", "inputHash", "comments",
                                              "costs",  "lightError",  "gainLight"};
  return names.count(key) > 0 || endsWith(key, "econds") || endsWith(key, "Bytes");
}

std::string withoutFolder(std::string text, const std::string& folder) {
  for (const auto& [place, name] : {std::pair(folder, "TMP"), std::pair(std::string(BOXPROBE_PROGRAM), "boxprobe"),
                                    std::pair(std::string(BOXPROBE_SOURCE_DIR), "SOURCE")}) {
    for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place)) {
      text.replace(at, place.size(), name);
    }
  }
  return std::regex_replace(text, std::regex("boxprobe-test-\\w{6}"), "TMP");
}

Json tidied(const Json& json, const std::string& folder) {
  if (json.is_object()) {
    Json result = Json::object();
    for (const auto& [key, value] : json.items()) {
      if (!leftOut(key)) result[key] = tidied(value, folder);
    }
    return result;
  }
  if (json.is_array()) {
    Json result = Json::array();
    for (const Json& value : json) result.push_back(tidied(value, folder));
    return result;
  }
  if (json.is_number_float()) return rounded(json.get<double>(), 8);
  if (json.is_string()) return withoutFolder(json.get<std::string>(), folder);
  return json;
}

Json meansOf(int width, int height, const std::vector<double>& pixels) {
  std::vector<double> means;
  double mean = 0.0;
  for (int y = 0; y + 3 <= height; y += 3) {
    for (int x = 0; x + 4 <= width; x += 4) {
      for (int c = 0; c < 3; ++c) {
        double sum = 0.0;
        for (int i = 0; i < 12; ++i) {
          const int column = x + i % 4, row = y + i / 4;
          sum += pixels[static_cast<std::size_t>(4 * (row * width + column) + c)];
        }
        means.push_back(sum / 12.0);
        mean += std::abs(sum / 12.0);
      }
    }
  }
  mean = std::max(mean / static_cast<double>(means.size()), 1e-12);
  Json thousandths = Json::array();
  for (const double each : means) thousandths.push_back(std::lround(1000.0 * each / mean));
  return {{"size", {width, height}}, {"mean", rounded(mean, 6)}, {kMeans, thousandths}};
}

/// Every so many, from the middle of its stride.
template <typename Values>
Json someOf(const Values& values, std::size_t count) {
  Json some = Json::array();
  for (std::size_t i = 0; i < std::min(count, values.size()); ++i) {
    some.push_back(rounded(static_cast<double>(values[(2 * i + 1) * values.size() / (2 * count)]), 5));
  }
  return some;
}

Json textValues(const std::string& text, const std::string& folder) {
  Json lines = Json::array();
  std::istringstream stream(withoutFolder(text, folder));
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

/// Half floats from `first` on.
std::vector<float> halves(const std::string& bytes, std::size_t first) {
  std::vector<float> values;
  for (std::size_t i = first; i + 1 < bytes.size(); i += 2) {
    std::uint16_t bits = 0;
    std::memcpy(&bits, bytes.data() + i, 2);
    half value;
    value.setBits(bits);
    values.push_back(std::isfinite(static_cast<float>(value)) ? static_cast<float>(value) : -1.0f);
  }
  return values;
}

Json attributesOf(const Imf::Header& header) {
  Json json = Json::object();
  for (auto it = header.begin(); it != header.end(); ++it) {
    const std::string name = it.name();
    if (leftOut(name) || name == "name") continue;
    const Imf::Attribute& attribute = it.attribute();
    if (const auto* number = dynamic_cast<const Imf::IntAttribute*>(&attribute)) json[name] = number->value();
    if (const auto* number = dynamic_cast<const Imf::FloatAttribute*>(&attribute)) {
      json[name] = rounded(static_cast<double>(number->value()), 7);
    }
    if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&attribute)) {
      json[name] = rounded(number->value(), 8);
    }
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute)) json[name] = text->value();
    if (const auto* v = dynamic_cast<const Imf::V3fAttribute*>(&attribute)) {
      for (const float x : {v->value().x, v->value().y, v->value().z})
        json[name].push_back(rounded(static_cast<double>(x), 7));
    }
    if (const auto* numbers = dynamic_cast<const Imf::FloatVectorAttribute*>(&attribute)) {
      json[name] = Json::array();
      for (const float x : numbers->value()) json[name].push_back(rounded(static_cast<double>(x), 6));
    }
  }
  return json;
}

/// Some values of each channel and level of a part.
Json texelsOf(Imf::MultiPartInputFile& file, int part, std::size_t count) {
  const Imf::Header& header = file.header(part);
  const bool tiled = header.type() == Imf::TILEDIMAGE;
  Json json = Json::object();
  std::vector<std::string> channels;
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it) channels.emplace_back(it.name());
  const auto read = [&](const Imath::Box2i& window, const std::string& label, const auto& readInto) {
    const auto width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
    const auto height = static_cast<std::size_t>(window.max.y - window.min.y + 1);
    std::map<std::string, std::vector<float>> values;
    Imf::FrameBuffer buffer;
    for (const std::string& channel : channels) {
      values[channel].resize(width * height);
      char* base = reinterpret_cast<char*>(values[channel].data()) -
                   4 * (static_cast<std::ptrdiff_t>(window.min.x) + window.min.y * static_cast<std::ptrdiff_t>(width));
      buffer.insert(channel, Imf::Slice(Imf::FLOAT, base, 4, 4 * width));
    }
    readInto(buffer);
    for (const std::string& channel : channels) {
      double sum = 0.0;
      for (const float x : values[channel]) sum += static_cast<double>(x);
      json[label + channel] = {{"mean", rounded(sum / static_cast<double>(width * height), 6)},
                               {"some", someOf(values[channel], count)}};
    }
  };
  if (tiled) {
    Imf::TiledInputPart input(file, part);
    for (int level = 0; level < input.numLevels(); ++level) {
      read(input.dataWindowForLevel(level), "level " + std::to_string(level) + " ",
           [&](const Imf::FrameBuffer& buffer) {
             input.setFrameBuffer(buffer);
             input.readTiles(0, input.numXTiles(level) - 1, 0, input.numYTiles(level) - 1, level);
           });
    }
  } else {
    Imf::InputPart input(file, part);
    const Imath::Box2i window = header.dataWindow();
    read(window, "", [&](const Imf::FrameBuffer& buffer) {
      input.setFrameBuffer(buffer);
      input.readPixels(window.min.y, window.max.y);
    });
  }
  return json;
}

Json exrValues(const std::string& path) {
  Imf::MultiPartInputFile file(path.c_str());
  if (file.parts() == 1) {
    const ImageRgbaF image = loadHdrImage(path);
    return meansOf(image.width, image.height, std::vector<double>(image.pixels.begin(), image.pixels.end()));
  }
  Json json = Json::object();
  for (int part = 0; part < file.parts(); ++part) {
    const std::string name = file.header(part).hasName() ? file.header(part).name() : std::to_string(part);
    if (part == 0) json[name + " attributes"] = attributesOf(file.header(part));
    json[name] = texelsOf(file, part, 4);
  }
  return json;
}

Json fileValues(const std::string& path, const std::string& folder) {
  const std::string bytes = readFile(path);
  const auto is = [&](const char* extension) { return endsWith(path, extension); };
  if (is(".exr")) return exrValues(path);
  if (is(".hdr")) {
    const ImageRgbaF image = loadHdrImage(path);
    return {{"size", {image.width, image.height}}, {"some", someOf(image.pixels, 47)}};
  }
  if (is(".png")) {
    const ImageRgba8 image = loadImage8(path);
    // Sheets are large: every fourth pixel of every fourth row, at most.
    if (image.width <= 64) {
      return meansOf(image.width, image.height, std::vector<double>(image.pixels.begin(), image.pixels.end()));
    }
    return {{"size", {image.width, image.height}}, {"some", someOf(image.pixels, 499)}};
  }
  if (is(".json")) return tidied(Json::parse(bytes), folder);
  if (is(".ktx2") || is(".dds")) {
    const std::size_t header = is(".dds") ? 148 : 0xf4;
    Json words = Json::array();
    for (std::size_t i = 0; i + 3 < header; i += 4) {
      std::uint32_t word = 0;
      std::memcpy(&word, bytes.data() + i, 4);
      words.push_back(word);
    }
    return {{"bytes", bytes.size()},
            {"header", words},
            {"some", someOf(halves(bytes, header + (is(".dds") ? 0 : 0x3c)), 97)}};
  }
  // Code for other programs is theirs to run; what it is told of the scene stands in the other files.
  if (is(".gdshader") || is(".glsl") || is(".hlsl") || is(".js") || is(".py")) return {{"written", true}};
  return textValues(bytes, folder);
}

std::string shown(const Json& json) {
  std::string text = json.dump();
  return text.size() > 90 ? text.substr(0, 87) + "..." : text;
}

class Comparison {
 public:
  explicit Comparison(bool drawn) : drawn_(drawn) {}

  void compare(const std::string& name, const Json& expected, const Json& actual) {
    if (expected.is_number() && actual.is_number()) {
      const double a = expected.get<double>(), b = actual.get<double>();
      const bool whole = expected.is_number_integer() && actual.is_number_integer();
      const double allowed = drawn_ ? 2e-4 + 2e-3 * std::abs(a) : 2e-6 + 1e-5 * std::abs(a);
      if (whole && !drawn_ ? a != b : !(std::abs(a - b) <= allowed)) report(name, expected, actual);
    } else if (expected.is_object() && actual.is_object() && expected.contains(kMeans) && actual.contains(kMeans)) {
      comparePictures(name, expected, actual);
    } else if (expected.is_object() && actual.is_object()) {
      for (const auto& [key, value] : expected.items()) {
        if (actual.contains(key)) {
          compare(name + "/" + key, value, actual[key]);
        } else {
          report(name + "/" + key, value, "gone");
        }
      }
      for (const auto& [key, value] : actual.items()) {
        if (!expected.contains(key)) report(name + "/" + key, "new", value);
      }
    } else if (expected.is_array() && actual.is_array() && expected.size() == actual.size()) {
      for (std::size_t i = 0; i < expected.size(); ++i) compare(name + "/" + std::to_string(i), expected[i], actual[i]);
    } else if (expected != actual) {
      report(name, expected, actual);
    }
  }

  std::vector<std::string> found;

 private:
  void comparePictures(const std::string& name, const Json& expected, const Json& actual) {
    if (expected["size"] != actual["size"]) return report(name + "/size", expected["size"], actual["size"]);
    const auto was = expected["mean"].get<double>(), is = actual["mean"].get<double>();
    const auto a = expected[kMeans].get<std::vector<double>>();
    auto b = actual[kMeans].get<std::vector<double>>();
    for (double& each : b) each *= is / was;
    std::vector<std::size_t> blocks;
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double apart = std::abs(a[i] - b[i]);
      if (apart <= 2.0 + 2e-3 * std::abs(a[i])) continue;
      largest = std::max(largest, apart);
      if (blocks.empty() || blocks.back() != i / 3) blocks.push_back(i / 3);
    }
    if (blocks.size() <= 3 && std::abs(is - was) <= 2e-3 * was) return;
    const auto columns = static_cast<std::size_t>(expected["size"][0].get<int>() / 4);
    const std::size_t first = blocks.empty() ? 0 : blocks[0];
    char text[480];
    std::snprintf(
        text, sizeof text,
        "%s: %zu of %zu places differ, by up to %.3g %% of the mean, which itself goes from %.5g to %.5g; the first "
        "is at column %zu, row %zu: %.0f %.0f %.0f thousandths are %.0f %.0f %.0f",
        name.c_str(), blocks.size(), a.size() / 3, 0.1 * largest, was, is, first % columns, first / columns,
        a[3 * first], a[3 * first + 1], a[3 * first + 2], b[3 * first], b[3 * first + 1], b[3 * first + 2]);
    found.emplace_back(text);
  }

  void report(const std::string& name, const Json& expected, const Json& actual) {
    std::string line = name + ": " + shown(expected) + " is " + shown(actual);
    if (expected.is_number() && actual.is_number() && expected.get<double>() != 0.0) {
      char percent[40];
      std::snprintf(percent, sizeof percent, " (%.3g %%)",
                    100.0 * (actual.get<double>() - expected.get<double>()) / std::abs(expected.get<double>()));
      line += percent;
    }
    found.push_back(line);
  }

  bool drawn_;
};

}  // namespace

Json printedValues(const std::string& text, const std::string& folder) {
  const Json json = Json::parse(text, nullptr, false);
  return json.is_discarded() ? Json{{"lines", textValues(text, folder)}} : tidied(json, folder);
}

Json writtenValues(const std::string& path, const std::string& folder) {
  if (!fs::is_directory(path)) return fileValues(path, folder);
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(path)) {
    if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), path).string());
  }
  Json json = Json::object();
  for (const std::string& file : files) {
    const Json values = fileValues((fs::path(path) / file).string(), folder);
    // Files of many parts: one entry for each, so that a line of the baseline is not too long.
    if (values.is_object() && endsWith(file, ".exr") && !values.contains(kMeans)) {
      for (const auto& [part, value] : values.items()) json[file + " " + part] = value;
    } else {
      json[file] = values;
    }
  }
  return json;
}

std::vector<std::string> differences(const Json& expected, const Json& actual, bool drawn) {
  Comparison comparison(drawn);
  comparison.compare("", expected, actual);
  return comparison.found;
}

std::string baselineText(const Json& runs) {
  std::string text = "{";
  const char* separator = "\n";
  for (const auto& [name, values] : runs.items()) {
    text += separator + Json(name).dump() + ": ";
    separator = ",\n";
    if (values.is_object()) {
      text += "{";
      const char* comma = "\n";
      for (const auto& [key, value] : values.items()) {
        text += comma + std::string("  ") + Json(key).dump() + ": " + value.dump();
        comma = ",\n";
      }
      text += "\n}";
    } else {
      text += values.dump();
    }
  }
  return text + "\n}\n";
}

}  // namespace boxprobe::test
