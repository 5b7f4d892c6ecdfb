// See shared_work.h. A file: the fingerprint of the rest, a line break, the rest.
#include "app/session/shared_work.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "app/session/scene_work.h"
#include "filters/core/base/errors.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/maps/content_hash.h"
#include "filters/vtk/probes/capture_key.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kHashDigits = 32;

std::optional<std::string> contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

Json jsonOf(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

glm::dvec3 vectorOf(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json jsonOf(const Box& box) {
  return {jsonOf(box.min), jsonOf(box.max)};
}

Box boxOf(const Json& json) {
  return {vectorOf(json.at(0)), vectorOf(json.at(1))};
}

Json jsonOf(const LookupErrors& errors) {
  return {errors.meanDegrees, errors.p95Degrees, errors.above5};
}

LookupErrors errorsOf(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

void append(std::string& bytes, const ImageRgbaF& image) {
  const std::int32_t size[] = {image.width, image.height};
  bytes.append(reinterpret_cast<const char*>(size), sizeof size);
  bytes.append(reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size() * sizeof(float));
}

/// The picture of that size at `at`, which then is behind it.
std::optional<ImageRgbaF> pictureAt(const std::string& bytes, std::size_t& at, int width, int height) {
  std::int32_t size[2];
  if (bytes.size() < at + sizeof size) return std::nullopt;
  std::memcpy(size, bytes.data() + at, sizeof size);
  at += sizeof size;
  if (size[0] != width || size[1] != height) return std::nullopt;
  ImageRgbaF image{width, height, {}};
  const std::size_t floats = 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if ((bytes.size() - at) / sizeof(float) < floats) return std::nullopt;
  image.pixels.resize(floats);
  std::memcpy(image.pixels.data(), bytes.data() + at, floats * sizeof(float));
  at += floats * sizeof(float);
  return image;
}

}  // namespace

SharedWork::SharedWork(std::string folder, std::string key, int index, int count)
    : folder_(std::move(folder)), key_(std::move(key)), index_(index), count_(count) {}

bool SharedWork::mine(std::size_t number) const {
  return index_ > 0 && number % static_cast<std::size_t>(count_) == static_cast<std::size_t>(index_ - 1);
}

std::string SharedWork::pathOf(const std::string& name) const {
  return (fs::path(folder_) / (name + "." + key_.substr(0, 16) + ".part")).string();
}

std::optional<std::string> SharedWork::findBytes(const std::string& name) const {
  const std::optional<std::string> content = contentOf(pathOf(name));
  if (!content || content->size() <= kHashDigits || (*content)[kHashDigits] != '\n') return std::nullopt;
  std::string bytes = content->substr(kHashDigits + 1);
  if (ContentHash().add(bytes).text() != content->substr(0, kHashDigits)) return std::nullopt;
  ++found_;
  return bytes;
}

void SharedWork::keepBytes(const std::string& name, const std::string& bytes) const {
  ++made_;
  writeTextAtomically(pathOf(name), ContentHash().add(bytes).text() + "\n" + bytes);
}

std::optional<BoxFit> SharedWork::find(const std::string& name, const Probe& start) const {
  const std::optional<std::string> bytes = findBytes(name);
  if (!bytes) return std::nullopt;
  try {
    const Json json = Json::parse(*bytes);
    BoxFit fit;
    const int outcome = json.at("outcome").get<int>();
    if (outcome < 0 || outcome > static_cast<int>(FitOutcome::Inside)) return std::nullopt;
    fit.outcome = static_cast<FitOutcome>(outcome);
    fit.probe = start;
    fit.probe.origin = vectorOf(json.at("origin"));
    fit.probe.box = boxOf(json.at("box"));
    fit.probe.rotationDegrees = vectorOf(json.at("rotation"));
    fit.probe.influence.reset();
    if (!json.at("influence").is_null()) fit.probe.influence = boxOf(json.at("influence"));
    fit.before = errorsOf(json.at("before"));
    fit.after = errorsOf(json.at("after"));
    for (std::size_t face = 0; face < fit.faces.size(); ++face) {
      const Json& row = json.at("faces").at(face);
      fit.faces[face] = {row.at(0).get<double>(), row.at(1).get<double>(), row.at(2).get<bool>()};
    }
    fit.hiddenBefore = json.at("hiddenBefore").get<double>();
    fit.hidden = json.at("hidden").get<double>();
    fit.open = json.at("open").get<double>();
    fit.seconds = json.at("seconds").get<double>();
    for (const Json& remark : json.at("remarks")) fit.remarks.push_back(Phrase::plain(remark.get<std::string>()));
    return fit;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;  // not a fit, or a number that JSON cannot hold
  }
}

void SharedWork::keep(const std::string& name, const BoxFit& fit) const {
  Json faces = Json::array();
  for (const FaceFit& face : fit.faces) faces.push_back({face.gainDegrees, face.sensitivity, face.free});
  const Json json = {{"outcome", static_cast<int>(fit.outcome)},
                     {"origin", jsonOf(fit.probe.origin)},
                     {"box", jsonOf(fit.probe.box)},
                     {"rotation", jsonOf(fit.probe.rotationDegrees)},
                     {"influence", fit.probe.influence ? jsonOf(*fit.probe.influence) : Json()},
                     {"before", jsonOf(fit.before)},
                     {"after", jsonOf(fit.after)},
                     {"faces", faces},
                     {"hiddenBefore", fit.hiddenBefore},
                     {"hidden", fit.hidden},
                     {"open", fit.open},
                     {"seconds", fit.seconds},
                     {"remarks", english(fit.remarks)}};
  keepBytes(name, json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::optional<ReferencePicture> SharedWork::findTraced(const std::string& name, int width, int height) const {
  const std::optional<std::string> bytes = findBytes(name);
  if (!bytes) return std::nullopt;
  std::size_t at = 0;
  std::optional<ImageRgbaF> color = pictureAt(*bytes, at, width, height);
  std::optional<ImageRgbaF> error = color ? pictureAt(*bytes, at, width, height) : std::nullopt;
  if (!error) return std::nullopt;
  return ReferencePicture{*std::move(color), *std::move(error), true};
}

void SharedWork::keepTraced(const std::string& name, const ReferencePicture& picture) const {
  std::string bytes;
  append(bytes, picture.color);
  append(bytes, picture.standardError);
  keepBytes(name, bytes);
}

std::optional<ImageRgbaF> SharedWork::findPicture(const std::string& name, int width, int height) const {
  const std::optional<std::string> bytes = findBytes(name);
  std::size_t at = 0;
  return bytes ? pictureAt(*bytes, at, width, height) : std::nullopt;
}

void SharedWork::keepPicture(const std::string& name, const ImageRgbaF& picture) const {
  std::string bytes;
  append(bytes, picture);
  keepBytes(name, bytes);
}

void SharedWork::remove() const {
  const std::string end = "." + key_.substr(0, 16) + ".part";
  std::vector<fs::path> ours;
  std::error_code error;
  for (fs::directory_iterator it(folder_, error), last; !error && it != last; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0) {
      ours.push_back(it->path());
    }
  }
  std::error_code ignored;  // another process may have been sooner
  for (const fs::path& path : ours) fs::remove(path, ignored);
  fs::remove(folder_, ignored);  // fails unless it is empty
}

std::string loadedSceneKey(const LoadedScene& loaded) {
  ContentHash hash;
  hash.add(BOXPROBE_VERSION).add(sceneText(loaded.scene, "/"));
  for (const std::string& object : objectContentKeys(loaded.models, loaded.models.size())) hash.add(object);
  // Where they stand, and what the scene's overrides call them.
  for (const auto& model : loaded.models) {
    for (const Instance& instance : model->instances) {
      hash.add(instance.node).addBytes(&instance.worldFromModel, sizeof instance.worldFromModel);
    }
  }
  if (const auto sky = loadSkyImage(loaded.scene)) hash.add(imageContentKey(*sky));
  for (const Probe& probe : loaded.scene.probes) {
    if (probe.mode == ProbeMode::Custom) hash.add(contentOf(probe.image).value_or(""));
  }
  return hash.text();
}

}  // namespace boxprobe
