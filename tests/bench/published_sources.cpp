// See published_sources.h. The text of every file comes from the source tree, not from the program: this definition of
// shaderSource() takes the place of the library's.
#include "tests/bench/published_sources.h"

#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "filters/math/shared/shader_source.h"

namespace boxprobe {

namespace {

bool published = false;

std::string fileText(const std::string& name) {
  std::ifstream stream(BOXPROBE_SOURCE_DIR "/shaders/" + name);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The same functions without guards, by the forms in shaders/published.
std::string publishedText(const std::string& name) {
  if (name == "shared/finite.glsl") {
    return "vec3 finiteOr(vec3 v, vec3 instead) { return v; }\nvec3 directionOr(vec3 v, vec3 instead) { return v; }\n"
           "float roughnessWithin(float roughness) { return roughness; }\n"
           "vec3 reflectedView(vec3 normal, vec3 view) { return reflect(-view, normal); }\n"
           "vec3 lookupDirection(vec3 direction) { return direction; }\n";
  }
  if (name == "technique/projection_box.glsl") {
    return fileText("published/box_max.glsl") +
           "ProbeHit projectBox(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)\n"
           "{ return publishedBoxMax(probe, position, reflection); }\n";
  }
  if (name == "technique/projection_sphere.glsl") {
    return fileText("published/sphere.glsl") +
           "ProbeHit projectSphere(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)\n"
           "{ return publishedSphere(probe, position, reflection); }\n";
  }
  if (name == "technique/evaluation_hdrp.glsl") {
    return fileText("published/distance_ratio.glsl") +
           "vec4 evaluateHdrp(PROBE_MAP map, ProbeShape probe, ShadingPoint point)\n{\n"
           "  ProbeHit hit = projectRay(probe, point.position, point.normal, point.reflection);\n"
           "  float p = publishedDistanceRoughness(hit.distance, hit.direction, point.roughness);\n"
           "  return fetchLevel(map, probe, hit.direction, levelForCurve(probe, p));\n}\n";
  }
  return fileText(name);
}

}  // namespace

std::string_view shaderSource(std::string_view name) {
  static std::map<std::pair<bool, std::string>, std::string> texts;
  const std::string file(name);
  const auto [at, made] = texts.try_emplace({published, file});
  if (made) at->second = published ? publishedText(file) : fileText(file);
  return at->second;
}

void bench::usePublishedShaders(bool use) {
  published = use;
}

}  // namespace boxprobe
