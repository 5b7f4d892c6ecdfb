// See glb_probes.h: what is read back. Nothing has checked the file before; counts, sizes and offsets are compared with
// the bytes that are there before anything is allocated.
#include <Imath/half.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <set>
#include <system_error>
#include <variant>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/cube/bake_folder.h"
#include "filters/io/engines/glb_probes.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/gltf/glb_document.h"
#include "filters/io/scene/scene_file.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

constexpr int kMostLevels = 13;  // of 4096² faces
constexpr const char* kMaps = "probes";

/// A value of the extension and where it stands, for messages.
class Entry {
 public:
  Entry(const Json& value, std::string place) : value_(value), place_(std::move(place)) {}

  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(oneLine(place_ + ": " + reason + "; export it again"));
  }
  bool has(const char* key) const { return value_.is_object() && value_.contains(key); }
  Entry at(const char* key) const {
    if (!has(key)) fail(std::string("has no \"") + key + "\"");
    return {value_[key], place_ + "." + key};
  }
  /// The elements; none if there is no such key.
  std::vector<Entry> list(const char* key) const {
    std::vector<Entry> elements;
    if (!has(key)) return elements;
    const Entry all = at(key);
    if (!all.value_.is_array()) all.fail("is not a list");
    for (const Json& value : all.value_)
      elements.emplace_back(value, all.place_ + "[" + std::to_string(elements.size()) + "]");
    return elements;
  }
  std::size_t whole(std::size_t most) const {
    if (!value_.is_number_unsigned() || value_.get<std::uint64_t>() > most) {
      fail("is no whole number from 0 to " + std::to_string(most));
    }
    return value_.get<std::size_t>();
  }
  double number() const {
    if (!value_.is_number() || !std::isfinite(value_.get<double>())) fail("is not a number");
    return value_.get<double>();
  }
  std::string text() const {
    if (!value_.is_string()) fail("is not a string");
    return value_.get<std::string>();
  }
  glm::dvec3 vector() const {
    if (!value_.is_array() || value_.size() != 3) fail("is not a list of three numbers");
    glm::dvec3 v;
    for (int i = 0; i < 3; ++i) v[i] = Entry(value_[static_cast<std::size_t>(i)], place_).number();
    return v;
  }
  const Json& json() const { return value_; }

 private:
  const Json& value_;
  std::string place_;
};

Json extensionOf(const std::string& path, const std::string& text) {
  checkJsonSyntax(text, path + ": JSON chunk");
  const Json root = Json::parse(text);
  const std::string place = path + ": " + kGlbExtension;
  const Entry extension = Entry(root, path).at("extensions").at(kGlbExtension);
  const Json* version = extension.has("version") ? &extension.at("version").json() : nullptr;
  if (version == nullptr || *version != 1) {
    throw InputError(place + (version == nullptr ? ": has no version" : ": is of version " + version->dump()) +
                     "; this program reads version 1");
  }
  return extension.json();
}

Entry entryOf(const std::string& path, const Json& extension) {
  return {extension, path + ": " + kGlbExtension};
}

/// Names of the pictures, safe to be written into a folder.
std::set<std::string> fileNames(const Entry& extension) {
  std::set<std::string> names;
  for (const Entry& file : extension.list("files")) {
    const std::string name = file.at("name").text();
    const bool plain = !name.empty() && name != "." && name != ".." && name.size() < 200 && name != kMaps &&
                       name.find_first_of(std::string("/\\\0", 3)) == std::string::npos;
    if (!plain) file.fail("\"" + name + "\" is no name of a file");
    if (!names.insert(name).second) file.fail("\"" + name + "\" is the name of two files");
  }
  return names;
}

void requirePicture(const std::set<std::string>& names, const std::string& file, const std::string& folder,
                    const Entry& extension, const std::string& place) {
  const fs::path path(file);
  if (path.parent_path() == fs::path(folder) && names.count(path.filename().string()) != 0) return;
  extension.fail("scene." + place + ": the file holds no picture " + file);
}

Scene sceneOf(const std::string& path, const Entry& extension, const std::string& folder) {
  const Entry stored = extension.at("scene");
  if (!stored.json().is_object()) stored.fail("is no scene");
  Json root = stored.json();
  for (const char* key : {"model", "models"}) {
    if (root.contains(key)) stored.fail(std::string("has a \"") + key + "\", which is the file itself");
  }
  Json model = {{"file", fs::absolute(path).string()}};
  if (extension.has("variant")) model["variant"] = extension.at("variant").text();
  if (extension.has("time")) model["time"] = extension.at("time").number();
  root["models"] = Json::array({model});
  Scene scene = parseScene(root.dump(-1, ' ', false, Json::error_handler_t::replace),
                           path + ": " + kGlbExtension + ".scene", folder);
  scene.models.front().file = path;
  const std::set<std::string> names = fileNames(extension);
  if (const auto* image = std::get_if<SkyImage>(&scene.sky)) {
    requirePicture(names, image->file, folder, extension, "sky.image");
  }
  for (const Probe& probe : scene.probes) {
    if (!probe.image.empty()) requirePicture(names, probe.image, folder, extension, "probes." + probe.name + ".image");
  }
  return scene;
}

/// The bytes of the view that an entry names, which must be so many.
std::string_view viewBytes(const GlbDocument& document, const Entry& entry, const char* key,
                           std::optional<std::uint64_t> wanted) {
  const Entry index = entry.at(key);
  const Json* views = document.json.contains("bufferViews") ? &document.json["bufferViews"] : nullptr;
  const std::size_t count = views != nullptr && views->is_array() ? views->size() : 0;
  if (count == 0) index.fail("the file has no buffer views");
  const std::size_t number = index.whole(count - 1);
  const Entry view((*views)[number], "bufferView " + std::to_string(number));
  const std::size_t all = document.binary.size();
  const bool known = view.has("byteLength") && view.has("buffer") && view.at("buffer").json() == 0;
  if (!known) index.fail("buffer view " + std::to_string(number) + " is not in the binary chunk");
  const auto numberOf = [&](const char* member, std::size_t standard) {
    const Json* value = view.has(member) ? &view.at(member).json() : nullptr;
    if (value == nullptr) return standard;
    return value->is_number_unsigned() ? std::min(value->get<std::size_t>(), all + 1) : all + 1;
  };
  const std::size_t offset = numberOf("byteOffset", 0), length = numberOf("byteLength", 0);
  if (offset > all || length > all - offset) {
    index.fail("buffer view " + std::to_string(number) + " lies outside of the file's " + std::to_string(all) +
               " bytes");
  }
  if (wanted && *wanted != length) {
    index.fail("buffer view " + std::to_string(number) + " has " + std::to_string(length) + " bytes and must have " +
               std::to_string(*wanted));
  }
  return std::string_view(document.binary).substr(offset, length);
}

void readHalves(std::string_view bytes, float* values) {
  for (std::size_t i = 0; i < bytes.size() / 2; ++i) {
    Imath::half half;
    half.setBits(static_cast<std::uint16_t>(static_cast<unsigned char>(bytes[2 * i]) |
                                            static_cast<unsigned char>(bytes[2 * i + 1]) << 8));
    const auto value = static_cast<float>(half);
    values[i] = std::isfinite(value) ? value : 0.0f;
  }
}

/// What is unpacked comes from the file once: entries may name one view again and again.
class Budget {
 public:
  explicit Budget(const GlbDocument& document) : left_(document.binary.size()) {}
  void spend(std::size_t bytes, const Entry& on) {
    if (bytes > left_) on.fail("with the ones before it has more bytes than the file");
    left_ -= bytes;
  }

 private:
  std::size_t left_;
};

BakedMaps readMaps(const GlbDocument& document, const Entry& map, Budget& budget) {
  if (map.at("encoding").text() != "rgba16f") map.at("encoding").fail("is not supported; expected rgba16f");
  const std::vector<Entry> levels = map.list("levels");
  if (levels.empty() || levels.size() > kMostLevels) map.fail("has no levels, or more than 13");
  const std::size_t size = levels.front().at("size").whole(4096);
  if (size == 0 || (size & (size - 1)) != 0 || size >> (levels.size() - 1) == 0) {
    levels.front().at("size").fail("does not fit " + std::to_string(levels.size()) + " levels");
  }
  std::vector<std::string_view> bytes;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const std::uint64_t side = size >> level;
    if (levels[level].at("size").whole(4096) != side) levels[level].at("size").fail("must be " + std::to_string(side));
    bytes.push_back(viewBytes(document, levels[level], "bufferView", 6 * side * side * 8));
    budget.spend(bytes.back().size(), levels[level]);
  }
  BakedMaps maps;
  maps.radiance = CubeMap(static_cast<int>(size), static_cast<int>(levels.size()));
  for (int level = 0; level < maps.radiance.levels(); ++level) {
    readHalves(bytes[static_cast<std::size_t>(level)], maps.radiance.face(level, 0));
  }
  if (map.has("distance")) {
    const Entry distance = map.at("distance");
    const std::size_t side = distance.at("size").whole(4096);
    if (side == 0) distance.at("size").fail("is 0");
    const std::string_view values = viewBytes(document, distance, "bufferView", std::uint64_t(6) * side * side * 4);
    budget.spend(values.size(), distance);
    maps.distance = CubeMap(static_cast<int>(side), 1);
    for (std::size_t i = 0; i < values.size() / 4; ++i) {
      float value = 0.0f;
      std::memcpy(&value, values.data() + 4 * i, 4);
      maps.distance.face(0, 0)[4 * i] = std::isfinite(value) && value > 0.0f ? value : 0.0f;
    }
  }
  const std::vector<Entry> irradiance = map.list("irradiance");
  if (irradiance.size() != maps.irradiance.size()) map.fail("needs nine \"irradiance\" coefficients");
  for (std::size_t i = 0; i < irradiance.size(); ++i) maps.irradiance[i] = glm::vec3(irradiance[i].vector());
  maps.capturedAt = map.at("capturedAt").vector();
  maps.capturedRotation = map.at("capturedRotationDegrees").vector();
  return maps;
}

void saveMap(const GlbDocument& document, const std::vector<Entry>& all, const Entry& owner, const Probe& probe,
             const std::string& folder, std::set<std::size_t>& used, Budget& budget) {
  if (all.empty()) owner.at("map").fail("the file has no maps");
  const std::size_t number = owner.at("map").whole(all.size() - 1);
  if (!used.insert(number).second) owner.at("map").fail("map " + std::to_string(number) + " has an owner already");
  const Entry& map = all[number];
  BakedMaps maps = readMaps(document, map, budget);
  if (!map.has("inputs")) return;  // of a probe that is not baked
  const auto record = BakeRecord::parse(map.at("inputs").text());
  if (!record) map.at("inputs").fail("is no record of a bake");
  BakeFolder::save(folder, probe, *record, std::move(maps), {map.at("program").text(), map.at("renderer").text()});
}

}  // namespace

bool holdsProbes(const std::string& path) {
  try {
    const auto text = glbJsonText(path);
    if (!text || text->find(kGlbExtension) == std::string::npos) return false;
    const Json root = Json::parse(*text, nullptr, false);
    return root.is_object() && root.contains("extensions") && root["extensions"].is_object() &&
           root["extensions"].contains(kGlbExtension);
  } catch (const Error&) {
    return false;
  }
}

Scene glbSceneOf(const std::string& path, const std::string& folder) {
  const auto text = glbJsonText(path);
  if (!text) throw InputError(path + ": is no .glb file");
  const Json extension = extensionOf(path, *text);
  return sceneOf(path, entryOf(path, extension), folder);
}

void unpackGlb(const std::string& path, const std::string& folder) {
  const GlbDocument document = readGlbDocument(path);
  const Json json = extensionOf(path, document.json.dump(-1, ' ', false, Json::error_handler_t::replace));
  const Entry extension = entryOf(path, json);
  const Scene scene = sceneOf(path, extension, folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw WorkError(folder + ": cannot create this folder: " + error.message());
  Budget forPictures(document), forMaps(document);
  for (const Entry& file : extension.list("files")) {
    const std::string_view bytes = viewBytes(document, file, "bufferView", std::nullopt);
    forPictures.spend(bytes.size(), file);
    writeTextAtomically((fs::path(folder) / file.at("name").text()).string(), std::string(bytes));
  }
  const std::string maps = (fs::path(folder) / kMaps).string();
  const std::vector<Entry> all = extension.list("maps");
  std::set<std::string> saved;
  std::set<std::size_t> used;
  for (const Entry& entry : extension.list("probes")) {
    const std::string name = entry.at("name").text();
    const auto index = findProbe(scene, name);
    if (!index) entry.fail("\"" + name + "\" is no probe of the scene");
    if (!saved.insert(name).second) entry.fail("\"" + name + "\" is there twice");
    if (entry.has("map")) saveMap(document, all, entry, scene.probes[*index], maps, used, forMaps);
  }
  if (extension.has("sky")) {
    Probe sky;
    sky.name.clear();
    saveMap(document, all, extension.at("sky"), sky, maps, used, forMaps);
  }
}

}  // namespace boxprobe
