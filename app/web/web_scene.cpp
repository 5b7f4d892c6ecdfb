// See web_scene.h.
#include "app/web/web_scene.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/session/load_scene.h"
#include "app/web/base64.h"
#include "filters/core/base/errors.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/probe_index.h"
#include "filters/io/engines/cube_container.h"
#include "filters/io/engines/export_cube.h"
#include "filters/io/engines/technique_text.h"
#include "filters/io/image/image_file.h"
#include "filters/math/cube/cube_filter.h"
#include "filters/math/sampling/brdf_table.h"
#include "filters/math/sampling/filter_lobe.h"
#include "filters/math/shared/shader_source.h"
#include "filters/reference/light/reference_sky.h"
#include "filters/reference/trace/triangle_scene.h"

namespace boxprobe {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::size_t kMostWebProbes = 4, kMostWebLights = 8;  // of an object, as the program; of data/web/room.js
constexpr int kSkyFaceSize = 128;
constexpr int kWebSamples = 12, kMostWebTaps = 192;  // of what the browser filters: WebGL2 promises 224 vectors

template <typename Vector>
OrderedJson numbersOf(const Vector& v) {
  OrderedJson json = OrderedJson::array();
  for (int i = 0; i < Vector::length(); ++i) json.push_back(v[i]);
  return json;
}

/// CRC-32, as PNG and ZIP have it.
unsigned long crc32Of(const std::string& bytes) {
  return ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}

OrderedJson shJson(const ShCoefficients& sh) {
  OrderedJson json = OrderedJson::array();
  for (const glm::vec3& c : sh) {
    for (int i = 0; i < 3; ++i) json.push_back(c[i]);
  }
  return json;
}

class Writer {
 public:
  Writer(const Scene& scene, const std::vector<ProbeCapture>& captures, int faceSize, std::string writer)
      : scene_(scene), captures_(captures), faceSize_(faceSize), writer_(std::move(writer)) {}

  WebScene write(const std::vector<std::shared_ptr<const Model>>& models) {
    OrderedJson json = {{"format", "boxprobe-web"},
                        {"version", 1},
                        {"writer", writer_},
                        {"exposure", scene_.exposure},
                        {"multiple", scene_.energy == Energy::Multiple}};
    json["cameras"] = camerasJson();
    json["lights"] = lightsJson();
    json["sky"] = skyJson();
    json["probes"] = probesJson();
    json["objects"] = objectsJson(makeTriangleScene(scene_, models));
    json["materials"] = materials_;
    json["splitSum"] = {{"size", kBrdfTableSize}, {"file", splitSumFile()}};
    json["prefilter"] = prefilterJson();
    json["shaders"] = shadersJson();
    for (const WebFile& file : made_.files) json["sums"][file.name] = crc32Of(file.bytes);
    made_.json = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    return std::move(made_);
  }

 private:
  std::string file(const std::string& name, const std::string& mime, std::string bytes) {
    made_.files.push_back({name, mime, std::move(bytes)});
    return name;
  }

  void remark(const std::string& text) {
    if (std::find(made_.remarks.begin(), made_.remarks.end(), text) == made_.remarks.end()) {
      made_.remarks.push_back(text);
    }
  }

  OrderedJson camerasJson() const {
    OrderedJson cameras = OrderedJson::array();
    for (const Camera& camera : scene_.cameras) {
      cameras.push_back({{"name", camera.name},
                         {"position", numbersOf(camera.position)},
                         {"target", numbersOf(camera.target)},
                         {"up", numbersOf(camera.up)},
                         {"verticalFovDegrees", camera.verticalFovDegrees}});
    }
    return cameras;
  }

  OrderedJson lightsJson() {
    OrderedJson lights = OrderedJson::array();
    // What stands still shadows every light then.
    const bool shapes = scene_.lamps == LampForm::Shapes && !captures_.empty();
    if (shapes) remark("lamps: the page lights from the probes' maps, as \"in-map\" does");
    for (const Light& light : scene_.lights) {
      if (lights.size() == kMostWebLights) {
        remark("lights: more than " + std::to_string(kMostWebLights) + "; the page draws the first of them");
        break;
      }
      if (shapes || light.shadows != LightShadows::None) remark("lights: the page draws no shadows");
      const auto cosine = [](double degrees) { return std::cos(glm::radians(degrees)); };
      lights.push_back({{"type", light.type == LightType::Directional ? 0
                                 : light.type == LightType::Point     ? 1
                                                                      : 2},
                        {"direction", numbersOf(glm::normalize(light.direction))},
                        {"position", numbersOf(light.position)},
                        {"radiance", numbersOf(light.color * light.intensity)},
                        {"perRange", light.range > 0.0 ? 1.0 / light.range : 0.0},
                        {"cosines", {cosine(light.outerConeDegrees), cosine(light.innerConeDegrees)}}});
    }
    return lights;
  }

  std::string cubeFile(const std::string& stem, const CubeMap& level0, int samples) {
    const HalfLoss loss = halfLoss(level0);
    if (loss.any()) {
      throw InputError(stem + ": " + std::to_string(loss.texelsNotFinite + loss.texelsAtLimit) +
                       " texels do not fit into half floats, which the page draws from; darken its source");
    }
    return file(stem + ".ktx2", "image/ktx2", encodeKtx2(ladderChain(level0, *findLadder("own"), samples), writer_));
  }

  OrderedJson skyJson() {
    const ReferenceSky sky(scene_.sky, loadSkyImage(scene_), scene_.skyRotationDegrees);
    SkyGradient gradient;
    if (const auto* color = std::get_if<SkyColor>(&scene_.sky)) {
      gradient = {color->color, color->color, color->color};
    } else if (const auto* given = std::get_if<SkyGradient>(&scene_.sky)) {
      gradient = *given;
    }
    const bool picture = std::holds_alternative<SkyImage>(scene_.sky);
    OrderedJson json = {{"picture", picture},
                        {"top", numbersOf(gradient.top)},
                        {"horizon", numbersOf(gradient.horizon)},
                        {"ground", numbersOf(gradient.ground)}};
    if (!picture && gradient.top + gradient.horizon + gradient.ground == glm::vec3(0.0f)) return json;  // black
    CubeMap level0(kSkyFaceSize, 1);
    std::array<std::vector<float>, 6> faces;
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < kSkyFaceSize; ++row) {
        for (int column = 0; column < kSkyFaceSize; ++column) {
          const auto place = [](int texel) { return 2.0f * (static_cast<float>(texel) + 0.5f) / kSkyFaceSize - 1.0f; };
          const glm::vec3 light = sky.radiance(glm::normalize(shading::cubeDirection(face, place(column), place(row))));
          level0.setTexel(0, face, column, row, glm::vec4(light, 1.0f));
        }
      }
      const float* texels = level0.face(0, face);
      faces[static_cast<std::size_t>(face)].assign(texels, texels + std::size_t(4) * kSkyFaceSize * kSkyFaceSize);
    }
    json["file"] = cubeFile("sky", level0, Probe().filterSamples);
    json["maxLevel"] = prefilterLevels(kSkyFaceSize) - 1;
    json["sh"] = shJson(irradianceCoefficients(faces, kSkyFaceSize));
    return json;
  }

  /// Nothing: the sky.
  static OrderedJson clearJson(const Clear& clear) {
    if (std::holds_alternative<ClearToSky>(clear)) return nullptr;
    const auto* color = std::get_if<glm::vec3>(&clear);
    return numbersOf(color != nullptr ? *color : glm::vec3(0.0f));
  }

  OrderedJson probesJson() {
    OrderedJson probes = OrderedJson::array();
    for (std::size_t i = 0; i < captures_.size(); ++i) {
      ExportSettings settings;
      settings.faceSize = std::min(faceSize_, captures_[i].level0.faceSize());
      Probe probe = captures_[i].probe;
      const CubeMap level0 = exportedLevel0(captures_[i], settings, probe);
      const ProbeGeometry g = probeGeometry(probe, probe.origin, probe.rotationDegrees);
      OrderedJson parameters;
      for (const ParameterRow& row : parameterRows()) {
        const std::string name(row.name);
        if (row.choice != nullptr) parameters[name] = {{"choice", g.parameters.*row.choice}};
        if (row.number != nullptr) parameters[name] = {{"number", g.parameters.*row.number}};
      }
      sizes_.insert(level0.faceSize());
      if (probe.filter != FilterKind::Ggx) remark("probes." + probe.name + ".filter: the page filters by GGX");
      probes.push_back(
          {{"name", probe.name},
           {"technique", techniqueId(g.technique)},
           {"origin", numbersOf(g.originWorld)},
           {"axes", {numbersOf(g.worldFromProbe[0]), numbersOf(g.worldFromProbe[1]), numbersOf(g.worldFromProbe[2])}},
           {"boxMin", numbersOf(g.boxMin)},
           {"boxMax", numbersOf(g.boxMax)},
           {"influenceMin", numbersOf(g.influenceMin)},
           {"influenceMax", numbersOf(g.influenceMax)},
           {"rateMin", numbersOf(g.rateMin)},
           {"rateMax", numbersOf(g.rateMax)},
           {"importance", probe.importance},
           {"bevelAndIntensity", {g.bevelRadius, g.bevelFromRoughness, g.intensity}},
           {"occlusion", numbersOf(g.occlusion)},
           {"open", std::holds_alternative<ClearToOpen>(probe.clear)},
           {"near", probe.nearDistance},
           {"far", probe.farDistance},
           {"clear", clearJson(probe.clear)},
           {"faceSize", level0.faceSize()},
           {"maxLevel", prefilterLevels(level0.faceSize()) - 1},
           {"parameters", parameters},
           {"sh", shJson(captures_[i].irradiance)},
           {"file", cubeFile("probe-" + std::to_string(i), level0, probe.filterSamples)}});
    }
    return probes;
  }

  /// Most important first, at most as many as an object is drawn with.
  OrderedJson probesOf(const std::string& node, const Box& bounds) const {
    const auto found = scene_.objects.find(node);
    const ObjectOverride settings = found != scene_.objects.end() ? found->second : ObjectOverride{};
    if (settings.probeUsage == ProbeUsage::Off) return OrderedJson::array();
    std::vector<std::size_t> order = ProbeIndex(scene_.probes).meeting(bounds);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const Probe &p = scene_.probes[a], &q = scene_.probes[b];
      return p.importance != q.importance ? p.importance > q.importance : p.name < q.name;
    });
    order.resize(std::min(order.size(), settings.probeUsage == ProbeUsage::Simple ? 1 : kMostWebProbes));
    return order;
  }

  OrderedJson objectsJson(const TriangleScene& triangles) {
    OrderedJson objects = OrderedJson::array();
    std::string vertices, indices;
    const auto append = [](std::string& bytes, const auto& value) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);  // little-endian, as browsers are
    };
    std::uint32_t first = 0;
    for (const TracedObject& object : triangles.objects) {
      if (!object.inPicture && !object.inProbes) continue;
      Box bounds{glm::dvec3(1e300), glm::dvec3(-1e300)};
      const std::size_t start = indices.size() / sizeof(std::uint32_t);
      for (const std::uint32_t index : object.indices) append(indices, first + index);
      for (std::size_t i = 0; i < object.positions.size(); ++i) {
        const glm::dvec3 world = triangles.anchorWorld + glm::dvec3(object.positions[i]);
        bounds = {glm::min(bounds.min, world), glm::max(bounds.max, world)};
        append(vertices, glm::vec3(world));
        append(vertices, object.normals.empty() ? glm::vec3(0.0f) : object.normals[i]);
        append(vertices, object.uv.empty() ? glm::vec2(0.0f) : object.uv[i]);
      }
      first += static_cast<std::uint32_t>(object.positions.size());
      if (!object.colors.empty()) remark("objects." + object.node + ": the page draws no vertex colours");
      const auto found = scene_.objects.find(object.node);
      if (found != scene_.objects.end() && found->second.weights == WeightMode::Object) {
        remark("objects." + object.node + ".weights: the page weighs probes by the pixel");
      }
      objects.push_back(
          {{"name", object.node},
           {"first", start},
           {"count", object.indices.size()},
           {"material", materialOf(object.material)},
           {"visible", object.inPicture},
           {"seenByProbes", object.inProbes},
           {"onlyProbes", found != scene_.objects.end() && found->second.probeUsage != ProbeUsage::BlendAndSky},
           {"min", numbersOf(bounds.min)},
           {"max", numbersOf(bounds.max)},
           {"probes", probesOf(object.node, bounds)}});
    }
    file("vertices.bin", "application/octet-stream", std::move(vertices));
    file("indices.bin", "application/octet-stream", std::move(indices));
    return objects;
  }

  OrderedJson textureOf(const TextureUse& use, const std::string& place) {
    if (!use.image) return nullptr;
    if (use.uvSet != 0) remark(place + ": the page draws every texture by the first set of coordinates");
    auto& name = textures_[use.image.get()];
    if (name.empty()) {
      const std::string wanted = "texture-" + std::to_string(textures_.size() - 1) + ".png";
      name = file(wanted, "image/png", encodePng(use.image->name.empty() ? wanted : use.image->name, *use.image));
    }
    OrderedJson transform = OrderedJson::array();
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row)
        transform.push_back(row < 2 ? use.uvTransform[column][row] : column == 2 ? 1.0f : 0.0f);
    }
    return {{"file", name},
            {"wrap", {static_cast<int>(use.wrapS), static_cast<int>(use.wrapT)}},
            {"nearest", use.nearest},
            {"transform", transform}};
  }

  std::size_t materialOf(const Material& m) {
    const std::string place = "materials." + m.name;
    const auto leftOut = [&](bool there, const char* what) {
      if (there) remark(place + ": the page draws no " + what);
    };
    leftOut(m.transmits(), "glass");
    leftOut(m.coat > 0.0f, "clear coat");
    leftOut(m.finish.any(), "sheen, anisotropy, iridescence or tint of a reflection");
    leftOut(m.normalTexture.image != nullptr && m.normalScale != 0.0f, "normal map");
    leftOut(m.occlusionTexture.image != nullptr, "occlusion texture");
    leftOut(m.alphaMode == AlphaMode::Blend, "blending");
    const float ratio = (m.reflectedIor() - 1.0f) / (m.reflectedIor() + 1.0f);
    const OrderedJson json = {{"name", m.name},
                              {"baseColor", numbersOf(m.baseColor)},
                              {"metallic", m.metallic},
                              {"roughness", m.roughness},
                              {"emissive", numbersOf(m.emissive)},
                              {"f0", ratio * ratio},
                              {"unlit", m.unlit},
                              {"doubleSided", m.doubleSided},
                              {"alphaCutoff", m.alphaMode == AlphaMode::Mask ? m.alphaCutoff : -1.0f},
                              {"baseColorTexture", textureOf(m.baseColorTexture, place)},
                              {"metallicRoughnessTexture", textureOf(m.metallicRoughnessTexture, place)},
                              {"emissiveTexture", textureOf(m.emissiveTexture, place)}};
    const auto same = std::find(materials_.begin(), materials_.end(), json);
    if (same != materials_.end()) return static_cast<std::size_t>(same - materials_.begin());
    materials_.push_back(json);
    return materials_.size() - 1;
  }

  std::string splitSumFile() {
    std::string bytes(sizeof kBrdfTable, '\0');
    std::memcpy(bytes.data(), kBrdfTable, sizeof kBrdfTable);
    return file("split-sum.bin", "application/octet-stream", std::move(bytes));
  }

  /// For captures in the browser: of each face size the lookups of every level from 1, x y level weight.
  OrderedJson prefilterJson() const {
    OrderedJson sizes = OrderedJson::object();
    for (const int size : sizes_) {
      PrefilterSettings settings;
      settings.samples = kWebSamples;
      OrderedJson levels = OrderedJson::array();
      const int last = prefilterLevels(size) - 1;
      for (int level = 1; level <= last; ++level) {
        OrderedJson taps = OrderedJson::array();
        for (const LobeTap& tap : lobeTaps(lobeOfLevel(settings, level, last),
                                           std::min(samplesOfLevel(settings, level), kMostWebTaps), size)) {
          for (const float value : {tap.direction.x, tap.direction.y, tap.level, tap.weight}) taps.push_back(value);
        }
        levels.push_back(taps);
      }
      sizes[std::to_string(size)] = levels;
    }
    return sizes;
  }

  OrderedJson shadersJson() const {
    const auto any = [&](auto has) { return std::any_of(captures_.begin(), captures_.end(), has); };
    const bool bevelled = any([](const ProbeCapture& c) { return c.probe.bevel.has_value(); });
    const bool occluded = any([](const ProbeCapture& c) { return c.probe.occlusion.has_value(); });
    TechniquePieces pieces = techniquePieces(bevelled, occluded);
    OrderedJson techniques = OrderedJson::array();
    for (const TechniquePieces::Row& row : pieces.rows) {
      techniques.push_back({{"projection", {row.projection, row.projectionLabel}},
                            {"evaluation", {row.evaluation, row.evaluationLabel}},
                            {"pieces", row.pieces}});
    }
    OrderedJson surface = OrderedJson::array();
    for (const char* name : {"shared/weights.glsl", "shared/fresnel.glsl", "shared/split_sum.glsl", "shared/sh.glsl",
                             "shared/light_falloff.glsl", "shared/display.glsl", "web/surface.glsl"}) {
      pieces.texts[name] = std::string(shaderSource(name));
      surface.push_back(name);
    }
    const std::string tone = toneFunction(scene_.tone);
    pieces.texts["shared/display.glsl"] = "#define BP_TONE " + tone + "\n" +
                                          (tone.empty() ? "" : std::string(shaderSource("shared/tone.glsl"))) +
                                          std::string(shaderSource("shared/display.glsl"));
    for (const char* name :
         {"shared/sky.glsl", "web/surface_vertex.glsl", "web/sky.glsl", "gpu/full_screen_vertex.glsl",
          "shared/cube.glsl", "shared/lobe_frame.glsl", "shared/edge_fixup.glsl", "shared/source_level.glsl",
          "gpu/nearest_half.glsl", "gpu/prefilter_lobe.glsl", "gpu/prefilter_source.glsl"}) {
      pieces.texts[name] = std::string(shaderSource(name));
    }
    return {{"texts", pieces.texts}, {"techniques", techniques}, {"surface", surface}, {"bevelled", bevelled}};
  }

  const Scene& scene_;
  const std::vector<ProbeCapture>& captures_;
  int faceSize_;
  std::string writer_;
  WebScene made_;
  OrderedJson materials_ = OrderedJson::array();
  std::map<const ImageRgba8*, std::string> textures_;
  std::set<int> sizes_;  ///< of the probes' faces
};

}  // namespace

WebScene webScene(const Scene& scene, const std::vector<std::shared_ptr<const Model>>& models,
                  const std::vector<ProbeCapture>& captures, int faceSize, const std::string& writer) {
  return Writer(scene, captures, faceSize, writer).write(models);
}

std::string withinOneText(const WebScene& scene) {
  OrderedJson json = OrderedJson::parse(scene.json);
  for (const WebFile& file : scene.files) {
    json["files"][file.name] = "data:" + file.mime + ";base64," + base64(file.bytes);
  }
  return json.dump();
}

}  // namespace boxprobe
