// Scene files: what parses also validates, is written and read again to the same values, and gives every probe finite
// numbers for the mathematics.
#include <cmath>

#include "filters/core/base/errors.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/io/scene/scene_file.h"
#include "tests/fuzz/parse_target.h"

namespace boxprobe::fuzz {

namespace {

const char* const kFolder = "scenes";

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void checkProbe(const Probe& probe) {
  const ProbeGeometry geometry = probeGeometry(probe, probe.origin);
  promise(finite(geometry.boxMin) && finite(geometry.boxMax), "a probe's box is not finite in its own frame");
  promise(finite(geometry.influenceMin) && finite(geometry.influenceMax), "a probe's influence is not finite");
  promise(!std::isnan(geometry.rateMin.x + geometry.rateMin.y + geometry.rateMin.z), "a blend rate is NaN");
  promise(!std::isnan(geometry.rateMax.x + geometry.rateMax.y + geometry.rateMax.z), "a blend rate is NaN");
  promise(std::isfinite(geometry.intensity), "a probe's intensity is not finite");
  (void)fullWeightEverywhere(probe, Box());
  (void)influenceBounds(probe);
}

}  // namespace

void parseSceneText(const std::string& bytes) {
  Scene scene;
  try {
    scene = parseScene(bytes, "input.boxprobe.json", kFolder);
  } catch (const InputError& refused) {
    checkRefusal(refused.what());
    return;
  }
  const std::string written = sceneText(scene, kFolder);
  const Scene again = parseScene(written, "written.boxprobe.json", kFolder);
  promise(again == scene, "what was written reads as another scene");
  promise(sceneText(again, kFolder) == written, "the same scene is written in two ways");
  for (const std::string& remark : featuresNotUsed(scene)) checkRefusal(remark);
  (void)unmatchedOverrides(scene, {});
  for (const Probe& probe : scene.probes) checkProbe(probe);
  // The single-field setter goes through the complete form, in which every key is written.
  Scene same = scene;
  setSceneFields(same, {"exposure=2"});
  same.exposure = scene.exposure;
  promise(same == scene, "setting one field changed another");
}

}  // namespace boxprobe::fuzz
