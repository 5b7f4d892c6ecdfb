// See glb_probes.h: what is written. glb_unpack.cpp reads it.
#include <Imath/half.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <variant>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/io/engines/glb_models.h"
#include "filters/io/engines/glb_probes.h"
#include "filters/io/engines/glb_scene.h"
#include "filters/io/files/read_file.h"
#include "filters/io/gltf/glb_document.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

template <class Vector>
Json glbBox(const Vector& low, const Vector& high) {
  return {{"min", glbNumbers(low)}, {"max", glbNumbers(high)}};
}

Json glbQuaternion(const glm::dmat3& rotation) {
  const glm::dquat q = glm::quat_cast(rotation);
  return {q.x, q.y, q.z, q.w};
}

void appendHalf(std::string& bytes, float value) {
  constexpr float kMostHalf = 65504.0f;
  const float finite = std::isfinite(value) ? std::clamp(value, -kMostHalf, kMostHalf) : 0.0f;
  const std::uint16_t bits = Imath::half(finite).bits();
  bytes += static_cast<char>(bits & 0xff);
  bytes += static_cast<char>(bits >> 8);
}

std::string glbHalves(const float* values, std::size_t count) {
  std::string bytes;
  bytes.reserve(2 * count);
  for (std::size_t i = 0; i < count; ++i) appendHalf(bytes, values[i]);
  return bytes;
}

std::string glbFloats(const float* values, std::size_t count, std::size_t stride) {
  std::string bytes(4 * count, '\0');  // little-endian, as this program's machines are
  for (std::size_t i = 0; i < count; ++i) std::memcpy(&bytes[4 * i], values + stride * i, 4);
  return bytes;
}

std::size_t texelsOf(const CubeMap& cube, int level) {
  const auto size = static_cast<std::size_t>(cube.levelSize(level));
  return 6 * size * size;
}

std::uint64_t mapBytes(const BakedMaps& maps) {
  std::uint64_t bytes = maps.distance.empty() ? 0 : 4 * texelsOf(maps.distance, 0);
  for (int level = 0; level < maps.radiance.levels(); ++level) bytes += 8 * texelsOf(maps.radiance, level);
  return bytes;
}

class Packer {
 public:
  Packer(const GlbScene& content, const std::string& path) : content_(content), path_(path) {}

  std::string pack(const SceneModels& models) {
    const bool joined = needsJoining(content_.scene);
    if (joined) {
      document_ = documentOfModels(content_.scene, models);
    } else {
      document_ = readGlbDocument(content_.scene.models.front().file);
      forgetBefore();
    }
    std::uint64_t bytes = content_.sky ? mapBytes(content_.sky->maps) : 0;
    for (const auto& maps : content_.maps) bytes += maps ? mapBytes(maps->maps) : 0;
    requireGlbSize(document_, bytes, path_);
    Scene placed = content_.scene;
    if (joined) placed.models = {ModelFile{}};  // they stand where they belong, without lights and cameras
    const Model noneOfItsOwn;
    Json materials =
        writeSceneInto(document_, placed, joined ? noneOfItsOwn : *models.front(), content_.diffuse.countedLights);
    Json extension = {{"version", 1}, {"writer", content_.writer}};
    const Json& views = document_.json["bufferViews"];
    extension["model"] = {{"bytes", document_.binary.size()}, {"bufferViews", views.is_array() ? views.size() : 0}};
    extension["probes"] = probesJson();
    if (content_.sky) extension["sky"] = {{"map", addMap(*content_.sky, nullptr)}};
    extension["maps"] = std::move(maps_);
    if (!lattices_.empty()) extension["lattices"] = std::move(lattices_);
    if (!lamps_.empty()) extension["lamps"] = std::move(lamps_);
    extension["scene"] = sceneJson();
    if (!materials.empty()) extension["materials"] = std::move(materials);
    const ModelFile& file = placed.models.front();
    if (!file.variant.empty()) extension["variant"] = file.variant;
    if (file.time) extension["time"] = *file.time;
    if (!files_.empty()) extension["files"] = std::move(files_);
    Json& root = document_.json;
    root["extensions"][kGlbExtension] = std::move(extension);
    Json& used = root["extensionsUsed"];
    if (!used.is_array()) used = Json::array();
    if (std::find(used.begin(), used.end(), kGlbExtension) == used.end()) used.push_back(kGlbExtension);
    return glbText(document_, path_);
  }

 private:
  /// A file that was written here has its materials as its model had them, and no maps, lattices and pictures of
  /// before.
  void forgetBefore() {
    Json& root = document_.json;
    if (!root.contains("extensions") || !root["extensions"].contains(kGlbExtension)) return;
    const Json extension = root["extensions"][kGlbExtension];
    root["extensions"].erase(kGlbExtension);
    cutAfterModel(extension);
    if (!extension.contains("materials") || !extension["materials"].is_object()) return;
    for (const auto& [number, material] : extension["materials"].items()) {
      root["materials"].at(std::stoul(number)) = material;  // checked when the model was read
    }
  }

  /// What was appended to the model's bytes goes, where nothing of the model lies behind it.
  void cutAfterModel(const Json& extension) {
    const Json before = extension.value("model", Json());
    Json& views = document_.json["bufferViews"];
    if (!before.is_object() || !views.is_array()) return;
    const Json count = before.value("bufferViews", Json()), bytes = before.value("bytes", Json());
    if (!count.is_number_unsigned() || !bytes.is_number_unsigned()) return;
    const std::size_t kept = count.get<std::size_t>(), end = bytes.get<std::size_t>();
    if (kept > views.size() || end > document_.binary.size()) return;
    for (const char* list : {"accessors", "images"}) {
      if (!document_.json.contains(list)) continue;
      for (const Json& user : document_.json[list]) {
        if (user.value("bufferView", std::size_t(0)) >= std::max<std::size_t>(kept, 1)) return;
      }
    }
    for (std::size_t i = 0; i < kept; ++i) {
      if (views[i].value("byteOffset", std::size_t(0)) + views[i].value("byteLength", std::size_t(0)) > end) return;
    }
    views.erase(views.begin() + static_cast<std::ptrdiff_t>(kept), views.end());
    document_.binary.resize(end);
  }

  Json probesJson() {
    Json probes = Json::array();
    for (std::size_t i = 0; i < content_.scene.probes.size(); ++i) {
      const Probe& probe = content_.scene.probes[i];
      const BakedMaps* maps = i < content_.maps.size() && content_.maps[i] ? &content_.maps[i]->maps : nullptr;
      const ProbeGeometry g = maps != nullptr ? probeGeometry(probe, maps->capturedAt, maps->capturedRotation)
                                              : probeGeometry(probe, probe.origin, probe.rotationDegrees);
      // Without the skin that it is drawn with.
      const glm::dvec3 low = glm::dvec3(g.boxMin) + (probe.influenceBox().min - probe.box.min);
      const glm::dvec3 high = glm::dvec3(g.boxMax) + (probe.influenceBox().max - probe.box.max);
      Json json = {{"name", probe.name},
                   {"origin", glbNumbers(g.originWorld)},
                   {"rotation", glbQuaternion(g.worldFromProbe)},
                   {"box", glbBox(g.boxMin, g.boxMax)},
                   {"influence", glbBox(low, high)},
                   {"blendDistance", glbBox(probe.blendDistance.min, probe.blendDistance.max)},
                   {"importance", probe.importance},
                   {"intensity", probe.intensity},
                   {"near", probe.nearDistance},
                   {"far", probe.farDistance},
                   {"technique", techniqueId(g.technique)}};
      if (maps != nullptr) {
        const glm::dmat3 worldFromMap = g.worldFromProbe * glm::transpose(g.mapFromProbe);
        json["map"] = addMap(*content_.maps[i], &worldFromMap);
        if (std::holds_alternative<ClearToOpen>(probe.clear)) json["open"] = true;
      }
      if (i < content_.diffuse.probes.size() && content_.diffuse.probes[i]) {
        const ProbeDiffuse& diffuse = *content_.diffuse.probes[i];
        if (diffuse.lattice) json["lattice"] = addLattice(*diffuse.lattice);
        for (const SceneLamp& lamp : diffuse.lamps) json["lamps"].push_back(lampOf(lamp));
      }
      probes.push_back(std::move(json));
    }
    return probes;
  }

  std::size_t addMap(const BakedProbeFile& file, const glm::dmat3* worldFromMap) {
    const BakedMaps& maps = file.maps;
    Json levels = Json::array();
    const int last = maps.radiance.maxLevel();
    for (int level = 0; level <= last; ++level) {
      const double alpha = last > 0 ? (std::exp2(level) - 1.0) / (std::exp2(last) - 1.0) : 0.0;
      levels.push_back({{"size", maps.radiance.levelSize(level)},
                        {"roughness", std::sqrt(alpha)},
                        {"bufferView", addBytes(document_, glbHalves(maps.radiance.face(level, 0),
                                                                     4 * texelsOf(maps.radiance, level)))}});
    }
    Json json = {{"encoding", "rgba16f"}, {"levels", levels}};
    if (worldFromMap != nullptr) json["rotation"] = glbQuaternion(*worldFromMap);
    json["capturedAt"] = glbNumbers(maps.capturedAt);
    json["capturedRotationDegrees"] = glbNumbers(maps.capturedRotation);
    for (const glm::vec3& c : maps.irradiance) json["irradiance"].push_back(glbNumbers(c));
    if (!maps.distance.empty()) {
      json["distance"] = {
          {"size", maps.distance.faceSize()},
          {"bufferView", addBytes(document_, glbFloats(maps.distance.face(0, 0), texelsOf(maps.distance, 0), 4))}};
    }
    if (!file.info.inputHash.empty()) {
      json["inputs"] = file.info.inputHash;
      json["program"] = file.info.program;
      json["renderer"] = file.info.renderer;
    }
    maps_.push_back(std::move(json));
    return maps_.size() - 1;
  }

  std::size_t addLattice(const DiffuseLattice& lattice) {
    Json json = {{"nodes", {lattice.nodes.x, lattice.nodes.y, lattice.nodes.z}},
                 {"min", glbNumbers(lattice.low)},
                 {"max", glbNumbers(lattice.high)}};
    json["bufferView"] = addBytes(document_, glbHalves(&lattice.texels.front().x, 4 * lattice.texels.size()));
    if (!lattice.cuts.empty()) {
      json["cuts"] = addBytes(document_, glbHalves(&lattice.cuts.front().x, 4 * lattice.cuts.size()));
    }
    lattices_.push_back(std::move(json));
    return lattices_.size() - 1;
  }

  std::size_t lampOf(const SceneLamp& lamp) {
    Json json = {{"node", lamp.node}};
    for (const glm::dvec3& corner : lamp.corners) json["corners"].push_back(glbNumbers(corner));
    json["radiance"] = glbNumbers(lamp.radiance);
    if (lamp.bothSides) json["bothSides"] = true;
    const auto same = std::find(lamps_.begin(), lamps_.end(), json);
    if (same != lamps_.end()) return static_cast<std::size_t>(same - lamps_.begin());
    lamps_.push_back(std::move(json));
    return lamps_.size() - 1;
  }

  /// The name of a picture within the file: its own, with a number before it where others have that name.
  std::string addFile(const std::string& path, const std::string& place) {
    if (const auto known = names_.find(path); known != names_.end()) return known->second;
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
      throw InputError(place + ": " + path + ": only pictures of one file go into a .glb; join its faces first");
    }
    std::string plain = fs::path(path).filename().string();
    std::replace(plain.begin(), plain.end(), '\\', '_');
    constexpr std::size_t kLongest = 150;  // bytes; the extension is at the end
    if (plain.size() > kLongest) plain.erase(0, plain.size() - kLongest);
    while (!plain.empty() && (plain.front() & 0xc0) == 0x80) plain.erase(0, 1);  // the rest of a letter
    std::string name = plain;
    const auto taken = [this](const std::string& wanted) {
      if (wanted == "probes") return true;  // the folder of the maps, where this is unpacked
      return std::any_of(names_.begin(), names_.end(), [&](const auto& entry) { return entry.second == wanted; });
    };
    for (int copy = 2; taken(name); ++copy) name = std::to_string(copy) + "-" + plain;
    const std::string bytes = readWholeFile(path);
    requireGlbSize(document_, bytes.size(), path_);
    files_.push_back({{"name", name}, {"bufferView", addBytes(document_, bytes)}});
    return names_[path] = name;
  }

  Json sceneJson() {
    Scene scene = content_.scene;
    scene.models.clear();
    if (auto* image = std::get_if<SkyImage>(&scene.sky)) image->file = addFile(image->file, "sky.image");
    for (Probe& probe : scene.probes) {
      if (!probe.image.empty()) probe.image = addFile(probe.image, "probes." + probe.name + ".image");
    }
    return sceneToJson(scene, "", JsonForm::Minimal);
  }

  const GlbScene& content_;
  const std::string& path_;
  GlbDocument document_;
  Json maps_ = Json::array(), lattices_ = Json::array(), lamps_ = Json::array(), files_ = Json::array();
  std::map<std::string, std::string> names_;
};

}  // namespace

void requireGlbScene(const Scene& scene, const std::string& path) {
  if (scene.models.empty()) throw InputError("models: the scene has none, which --format glb needs; add one");
  std::uint64_t bytes = 0;
  for (const ModelFile& model : scene.models) bytes += requireInputFile(model.file);
  for (const Probe& probe : scene.probes) {
    const auto size = static_cast<std::uint64_t>(probe.faceSize);
    bytes += 6 * size * size * (8 * 4 / 3 + 4);
  }
  requireGlbSize({}, bytes, path);
}

std::string glbWithProbes(const GlbScene& content, const SceneModels& models, const std::string& path) {
  requireGlbScene(content.scene, path);
  try {
    return Packer(content, path).pack(models);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& problem) {
    // A value of another kind than glTF asks for, which reading the model did not need.
    throw InputError(oneLine(content.scene.models.front().file + ": " + problem.what() + "; export it again"));
  }
}

}  // namespace boxprobe
