// See extreme_scenes.h.
#include "app/cli/command/extreme_scenes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/core/geometry/world_extent.h"
#include "filters/core/scene/scene_fields.h"
#include "filters/fit/fit_model.h"
#include "filters/fit/fit_probe.h"
#include "filters/fit/place_probes.h"
#include "filters/reference/light/reference_scene.h"
#include "filters/stress/stress_random.h"

namespace boxprobe {

namespace {

using stress::StressRandom;
using Models = std::vector<std::shared_ptr<const Model>>;

/// A size: ordinary, or from the smallest to the largest that a field takes.
double anySize(StressRandom& random) {
  if (random.chance(0.4)) return random.between(0.1, 30.0);
  return random.chance(0.1) ? (random.chance(0.5) ? 1e18 : 1e-18) : random.logBetween(1e-18, 1e18);
}

double anyNumber(StressRandom& random) {
  return random.chance(0.2) ? 0.0 : random.sign() * anySize(random);
}

glm::dvec3 anyVector(StressRandom& random) {
  const double x = anyNumber(random), y = anyNumber(random);
  return {x, y, anyNumber(random)};
}

glm::dvec3 anyTurn(StressRandom& random) {
  if (random.chance(0.5)) return glm::dvec3(0.0);
  const double x = random.between(-360.0, 360.0), y = random.between(-360.0, 360.0);
  return {x, y, random.between(-360.0, 360.0)};
}

/// A box, a single triangle, a flat sheet, or points anywhere.
Mesh anyMesh(StressRandom& random) {
  Mesh mesh;
  const int kind = random.below(4);
  const double size = anySize(random);
  const glm::dvec3 sides(size, random.chance(0.2) ? 0.0 : size * random.between(0.1, 3.0),
                         size * random.between(0.1, 3.0));
  const int corners = kind == 0 ? 3 : kind == 1 ? 4 : 8;
  for (int i = 0; i < corners; ++i) {
    const glm::dvec3 unit((i & 1) != 0 ? 0.5 : -0.5, (i & 2) != 0 ? 0.5 : -0.5, (i & 4) != 0 ? 0.5 : -0.5);
    const glm::dvec3 corner = kind == 3 ? anyVector(random) : unit * sides;
    mesh.positions.emplace_back(glm::clamp(corner, glm::dvec3(-1e18), glm::dvec3(1e18)));
  }
  const int triangles = kind == 0 ? 1 : kind == 1 ? 2 : 12;
  static constexpr std::uint32_t kBox[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                             2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  for (int i = 0; i < 3 * triangles; ++i) mesh.indices.push_back(kBox[i] % static_cast<std::uint32_t>(corners));
  return mesh;
}

std::shared_ptr<const Model> anyModel(StressRandom& random) {
  auto model = std::make_shared<Model>();
  Material material;
  material.name = "m";
  material.metallic = static_cast<float>(random.unit());
  material.roughness = static_cast<float>(random.unit());
  if (random.chance(0.3)) material.emissive = glm::vec3(static_cast<float>(random.logBetween(1e-6, 1e6)));
  model->materials.push_back(material);
  const int count = 1 + random.below(3);
  for (int i = 0; i < count; ++i) {
    model->meshes.push_back(anyMesh(random));
    model->meshes.back().material = 0;
    Instance instance;
    instance.node = "n" + std::to_string(i);
    instance.mesh = i;
    if (random.chance(0.5)) {
      instance.worldFromModel = glm::translate(glm::dmat4(1.0), anyVector(random)) *
                                glm::scale(glm::dmat4(1.0), glm::dvec3(random.sign() * anySize(random)));
    }
    model->instances.push_back(instance);
  }
  return model;
}

Box anyBox(StressRandom& random) {
  const glm::dvec3 a = anyVector(random);
  glm::dvec3 sides(0.0);
  for (int axis = 0; axis < 3; ++axis) sides[axis] = anySize(random);
  return {a, glm::min(a + sides, glm::dvec3(1e18))};
}

Scene anyScene(StressRandom& random) {
  Scene scene;
  ModelFile file;
  file.file = "extreme.glb";
  if (random.chance(0.5)) file.scale = anySize(random);
  if (random.chance(0.5)) file.translation = anyVector(random);
  file.rotationDegrees = anyTurn(random);
  file.unit = static_cast<LengthUnit>(random.below(5));
  file.upAxis = static_cast<UpAxis>(random.below(3));
  scene.models.push_back(file);
  if (random.chance(0.5)) {
    ObjectOverride moved;
    moved.translation = anyVector(random);
    moved.rotationDegrees = anyTurn(random);
    scene.objects["n0"] = moved;
  }
  Camera camera;
  camera.name = "main";
  camera.position = anyVector(random);
  camera.target = camera.position + anySize(random) * random.direction();
  if (random.chance(0.3)) camera.parallelHeight = anySize(random);
  scene.cameras.push_back(camera);
  Light light;
  light.type = static_cast<LightType>(random.below(3));
  light.position = anyVector(random);
  scene.lights.push_back(light);
  Probe probe;
  probe.name = "p";
  probe.box = anyBox(random);
  probe.origin = random.chance(0.7) ? probe.box.center() : anyVector(random);
  probe.rotationDegrees = anyTurn(random);
  scene.probes.push_back(probe);
  return scene;
}

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool finite(const Probe& probe) {
  return finite(probe.box.min) && finite(probe.box.max) && finite(probe.origin);
}

/// What was no number; empty if all are.
std::string tried(Scene scene, const Models& models, StressRandom& random) {
  constexpr int kRays = 64;
  const int kind = random.below(4);
  if (kind == 0) {
    FitWishes wishes;
    wishes.box.rays = kRays;
    fitModel(scene, models, wishes);
    for (const Probe& probe : scene.probes) {
      if (!finite(probe)) return "the probe of a bare model";
    }
    return {};
  }
  if (kind == 1) {
    ProbeFitter fitter(scene, models);
    BoxFitSettings settings;
    settings.rays = kRays;
    const auto fit =
        random.chance(0.5) ? fitter.fitWithOrigin(scene.probes[0], settings) : fitter.fit(scene.probes[0], settings);
    return fit && !finite(fit->probe) ? "a fitted box" : std::string();
  }
  if (kind == 2) {
    PlaceSettings settings;
    settings.most = 2;
    settings.rays = kRays;
    if (const auto placement = placeProbes(scene, models, settings)) {
      for (const Probe& probe : placement->all()) {
        if (!finite(probe)) return "a placed probe";
      }
    }
    return {};
  }
  ReferenceSettings settings;
  settings.width = 4;
  settings.height = 3;
  settings.samplesPerPixel = 1;
  settings.raysPerPixel = 8;
  settings.full = random.chance(0.5);
  const ReferencePicture picture = ReferenceScene(scene, models, nullptr).render(scene.cameras[0], settings);
  for (const float value : picture.color.pixels) {
    if (!std::isfinite(value)) return "a pixel";
  }
  return {};
}

}  // namespace

ExtremeScenesResult runExtremeScenes(std::uint64_t first, std::uint64_t count, std::uint64_t seed,
                                     const std::function<bool(double)>& progress) {
  ExtremeScenesResult result;
  for (; result.count < count; ++result.count) {
    if (progress && !progress(static_cast<double>(result.count) / static_cast<double>(count))) break;
    const std::uint64_t number = first + result.count;
    StressRandom mixed(seed ^ stress::idHash(kExtremeScenes));
    StressRandom random(mixed.next() ^ (number * 0xd1342543de82ef95ULL));
    try {
      const Models models = {anyModel(random)};
      Scene scene = anyScene(random);
      validate(scene);
      checkGeometry(scene, models);
      const std::string wrong = tried(std::move(scene), models, random);
      if (wrong.empty()) continue;
      if (++result.nonFinite == 1) result.worst = "scene " + std::to_string(number) + ": " + wrong;
    } catch (const Error&) {
      ++result.refused;
    }
  }
  return result;
}

nlohmann::ordered_json extremeScenesLine(const ExtremeScenesResult& result, std::uint64_t seed) {
  return {{"class", kExtremeScenes}, {"technique", "scene"},      {"seed", seed},
          {"count", result.count},   {"refused", result.refused}, {"nonFinite", result.nonFinite}};
}

std::string extremeScenesText(const ExtremeScenesResult& result) {
  return std::string(kExtremeScenes) + ": " + std::to_string(result.count) + " scenes, " +
         std::to_string(result.refused) + " refused by a message, " + std::to_string(result.nonFinite) +
         " with what is no number\n";
}

}  // namespace boxprobe
