#include "tests/stress/random_edits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/core/scene/technique_parameters.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe::test {

namespace {

std::vector<std::string> allTechniques() {
  std::vector<std::string> ids;
  for (std::size_t p = 0; p < projectionRows().size(); ++p) {
    for (std::size_t e = 0; e < evaluationRows().size(); ++e) {
      ids.push_back(techniqueId({static_cast<int>(p), static_cast<int>(e)}));
    }
  }
  return ids;
}

}  // namespace

RandomEdits::RandomEdits(unsigned seed, EditLimits limits) : random_(seed), limits_(std::move(limits)) {
  if (limits_.techniques.empty()) limits_.techniques = allTechniques();
}

// Not the standard's distributions: those may differ from library to library, and a seed should mean the same edits.
std::size_t RandomEdits::below(std::size_t count) {
  return random_() % count;
}
double RandomEdits::number(double low, double high) {
  return low + (high - low) * (random_() / 4294967296.0);
}
glm::dvec3 RandomEdits::vector(double low, double high) {
  const double x = number(low, high), y = number(low, high), z = number(low, high);
  return {x, y, z};
}
glm::vec3 RandomEdits::color() {
  return glm::vec3(vector(0.0, 2.0));
}
Box RandomEdits::box() {
  const glm::dvec3 middle = vector(-3.0, 3.0), half = vector(0.0, 4.0);
  return {middle - half, middle + half};
}
std::string RandomEdits::name() {
  static const char* const kNames[] = {"probe", "a \"quoted\" one", "back\\slash", "größe", "[0]", "a.b", "日本", "/"};
  return std::string(kNames[below(8)]) + " " + std::to_string(below(1000));
}

void RandomEdits::changeTechnique(Probe& probe) {
  switch (below(3)) {
    case 0:
      probe.technique = of(limits_.techniques);
      break;
    case 1:
      probe.projection = !probe.projection;
      break;
    default: {
      const ParameterRow& row = parameterRows()[below(parameterRows().size())];
      double value = row.kind == ParameterKind::Switch   ? static_cast<double>(below(2))
                     : row.kind == ParameterKind::Choice ? static_cast<double>(below(row.choices.size()))
                                                         : number(row.min, row.max);
      if (row.kind == ParameterKind::WholeNumber) value = std::floor(value);
      setParameter(probe, row, value);
    }
  }
}

void RandomEdits::changeCapture(Probe& probe) {
  switch (below(limits_.folder.empty() ? 8 : 10)) {
    case 0:
      probe.origin = vector(-3.0, 3.0);
      break;
    case 1:
      probe.nearDistance = number(0.001, 0.1);
      probe.farDistance = number(10.0, 1000.0);
      break;
    case 2:
      if (oneIn(3)) {
        probe.clear = ClearToSky();
      } else if (oneIn(2)) {
        probe.clear = ClearToNone();
      } else {
        probe.clear = color();
      }
      break;
    case 3:
      probe.faceSize = 16;
      while (probe.faceSize < limits_.largestFace && !oneIn(2)) probe.faceSize *= 2;
      break;
    case 4:
      probe.bounces = 1 + static_cast<int>(below(static_cast<std::size_t>(limits_.mostBounces)));
      break;
    case 5:
      probe.filter = oneIn(2) ? FilterKind::Ggx : FilterKind::Gaussian;
      probe.filterSamples = 8 + static_cast<int>(below(57));
      break;
    case 6:
      probe.samplesPerPixel = oneIn(2) ? 1 : 4;
      probe.hides = oneIn(2) ? std::vector<std::string>{of(limits_.nodes)} : std::vector<std::string>();
      break;
    case 7:
      probe.mode = oneIn(2) ? ProbeMode::Baked : ProbeMode::Realtime;
      break;
    default:
      probe.mode = ProbeMode::Custom;
      probe.image = limits_.folder + "/pictures/sky " + std::to_string(below(3)) + ".exr";
      probe.imageLayout = static_cast<CubeLayout>(below(5));
      probe.cubeView = static_cast<CubeView>(below(2));
  }
}

void RandomEdits::changeProbe(Probe& probe) {
  switch (below(9)) {
    case 0:
      probe.box = box();
      break;
    case 1:
      probe.rotationDegrees = vector(-180.0, 180.0);
      break;
    case 2:
      probe.influence = oneIn(2) ? std::optional<Box>(box()) : std::nullopt;
      break;
    case 3:
      probe.blendDistance = {vector(0.0, 2.0), vector(0.0, 2.0)};
      break;
    case 4:
      probe.importance = std::floor(number(-3.0, 3.0));
      break;
    case 5:
      probe.intensity = number(0.0, 3.0);
      break;
    case 6:
      probe.bevel = oneIn(2) ? std::optional<Bevel>({number(0.0, 1.0), number(0.0, 1.0)}) : std::nullopt;
      probe.lattice = oneIn(2) ? std::optional<ProbeLattice>({oneIn(2), number(0.1, 3.0)}) : std::nullopt;
      probe.occlusion = oneIn(2) ? std::optional<BoxOcclusion>({number(0.0, 2.0), 1.0, 0.5}) : std::nullopt;
      break;
    case 7:
      changeTechnique(probe);
      break;
    default:
      changeCapture(probe);
  }
}

void RandomEdits::changeList(Scene& scene) {
  std::vector<Probe>& probes = scene.probes;
  const std::size_t kind = below(5);
  if (kind == 0 && probes.size() < limits_.mostProbes) {
    Probe probe = probes.empty() || oneIn(2) ? Probe() : probes[below(probes.size())];
    probe.name = unusedProbeName(scene, name());
    probe.box = box();
    probes.insert(probes.begin() + static_cast<std::ptrdiff_t>(below(probes.size() + 1)), probe);
  } else if (probes.empty()) {
    return;
  } else if (kind == 1) {
    probes.erase(probes.begin() + static_cast<std::ptrdiff_t>(below(probes.size())));
  } else if (kind == 2) {
    Probe& renamed = probes[below(probes.size())];
    renamed.name.clear();
    renamed.name = unusedProbeName(scene, name());
  } else if (kind == 3) {
    std::swap(probes[below(probes.size())], probes[below(probes.size())]);
  } else {
    const glm::dvec3 step = vector(-1.0, 1.0);
    Probe& moved = probes[below(probes.size())];
    moved.origin += step;
    moved.box.min += step;
    moved.box.max += step;
  }
}

void RandomEdits::changeSurroundings(Scene& scene) {
  switch (below(limits_.folder.empty() ? 6 : 7)) {
    case 0: {
      MaterialOverride& material = scene.materials[of(limits_.materials)];
      material.roughness = static_cast<float>(number(0.0, 1.0));
      material.metallic = static_cast<float>(below(2));
      if (oneIn(2)) material.baseColor = color();
      if (oneIn(4)) material = {};
      break;
    }
    case 1: {
      ObjectOverride& object = scene.objects[of(limits_.nodes)];
      object.visible = !oneIn(4);
      object.seenByProbes = !oneIn(4);
      object.dynamic = oneIn(4);
      if (oneIn(4)) scene.objects.erase(of(limits_.nodes));
      break;
    }
    case 2:
      if (oneIn(3) && !scene.lights.empty()) {
        scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(below(scene.lights.size())));
      } else if (scene.lights.size() < 4) {
        Light light;
        light.type = oneIn(2) ? LightType::Point : LightType::Directional;
        if (light.type == LightType::Point) light.position = vector(-3.0, 3.0);
        if (light.type == LightType::Directional) light.direction = vector(-1.0, -0.1);
        light.color = color();
        light.intensity = static_cast<float>(number(0.0, 5.0));
        scene.lights.push_back(light);
      }
      break;
    case 3:
      if (oneIn(2)) {
        scene.sky = SkyColor{color()};
      } else {
        scene.sky = SkyGradient{color(), color(), color()};
      }
      break;
    case 4:
      scene.exposure = number(0.0, 4.0);
      break;
    case 5: {
      Camera camera;
      camera.name = "camera " + std::to_string(below(3));
      camera.position = vector(1.0, 4.0);
      camera.target = vector(-1.0, 0.0);
      const auto same = std::find_if(scene.cameras.begin(), scene.cameras.end(),
                                     [&](const Camera& other) { return other.name == camera.name; });
      if (same == scene.cameras.end()) {
        scene.cameras.push_back(camera);
      } else {
        *same = camera;
      }
      break;
    }
    default:
      scene.models.assign(below(3), {limits_.folder + "/model " + std::to_string(below(3)) + ".glb", vector(-9.0, 9.0),
                                     vector(0.0, 360.0), number(0.1, 10.0)});
      if (oneIn(2)) {
        scene.sky = SkyImage{limits_.folder + "/sky.hdr", CubeView::Outside, static_cast<SkySunForm>(below(2))};
      }
  }
}

std::function<void(Scene&)> RandomEdits::next(const Scene& scene) {
  Scene result = scene;
  if (!result.probes.empty() && !oneIn(3)) {
    changeProbe(result.probes[below(result.probes.size())]);
  } else if (oneIn(2)) {
    changeList(result);
  } else {
    changeSurroundings(result);
  }
  return [result](Scene& edited) { edited = result; };
}

std::function<void(Scene&)> RandomEdits::nextInvalid(const Scene& scene) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const std::size_t kind = below(scene.probes.empty() ? 2 : 8);
  const std::size_t index = scene.probes.empty() ? 0 : below(scene.probes.size());
  return [kind, index](Scene& edited) {
    if (kind == 0) edited.exposure = -1.0;
    if (kind == 1) edited.cameras.push_back({"", {}, {1, 0, 0}, {0, 1, 0}, 45.0});
    if (kind < 2) return;
    Probe& probe = edited.probes[index];
    if (kind == 2) probe.box.min.y = probe.box.max.y + 1.0;
    if (kind == 3) probe.name.clear();
    if (kind == 4) edited.probes.push_back(Probe(probe));
    if (kind == 5) probe.origin.z = kNaN;
    if (kind == 6) probe.technique = "no such technique";
    if (kind == 7) probe.faceSize = 100;
  };
}

}  // namespace boxprobe::test
