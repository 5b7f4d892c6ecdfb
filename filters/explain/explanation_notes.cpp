#include "filters/explain/explanation_notes.h"

#include <glm/geometric.hpp>

#include "filters/core/base/fixed_text.h"

namespace boxprobe {

namespace {

bool inside(const glm::vec3& p, const glm::vec3& low, const glm::vec3& high, float slack) {
  for (int i = 0; i < 3; ++i) {
    if (p[i] < low[i] - slack || p[i] > high[i] + slack) return false;
  }
  return true;
}

void addProbeNotes(const ProbeExplanation& p, std::vector<std::string>& notes) {
  if (p.weight <= 0.0f) {
    notes.push_back("Probe \"" + p.name + "\": its weight is 0 here, so it is not sampled.");
    return;
  }
  if (!p.captured) notes.push_back("Probe \"" + p.name + "\" has not been captured yet: it reflects nothing.");
  if (!p.hitDistance) {
    notes.push_back("Probe \"" + p.name + "\": technique " + p.technique +
                    " has no box to hit, so hit point and distance are undefined; the surroundings are taken to be "
                    "infinitely far away.");
  }
  if (!p.slabFactors) return;
  const float skin = 1.0e-4f * glm::length(p.boxMax - p.boxMin);
  if (!inside(glm::vec3(0.0f), p.boxMin, p.boxMax, 0.0f)) {
    notes.push_back("Probe \"" + p.name +
                    "\": the capture origin lies outside the projection box, so a part of the sampled surfaces was "
                    "never captured from inside the box.");
  }
  if (!inside(p.positionProbe, p.boxMin, p.boxMax, skin)) {
    notes.push_back("Probe \"" + p.name +
                    "\": the point lies outside the projection box; distances to planes behind it count as 0 and "
                    "the hit is pulled on to the box.");
  }
  if (!p.trueDistance && p.captured) {
    notes.push_back("Probe \"" + p.name +
                    "\": its distances do not give the true hit here (open sky, or hidden from the capture origin).");
  }
}

}  // namespace

void addNotes(Explanation& e, const ExplainInput& in) {
  const SurfacePoint& s = e.surface;
  if (s.opacity < 0.999f) {
    e.notes.emplace_back("The surface is translucent. What lies behind it shows through and is not explained here.");
  }
  if (e.glass && e.glass->stands > 0.0f) {
    e.notes.push_back("Light passes the glass nearly straight: " + fixedText(100.0 * double(e.glass->stands), 1) +
                      " % of what the picture shows here is what is drawn behind, in place of the lookup, and is not "
                      "part of this.");
  } else if (e.glass && e.glass->reflectance < 1.0f) {
    e.notes.emplace_back(
        "Where something opaque is drawn along the refracted ray, the picture shows that in place of this lookup.");
  }
  if (e.probes.empty()) {
    e.notes.emplace_back(
        "No probe lights this object, because none reaches it or its probeMode is off. The current sky shows through, "
        "not box-projected.");
  }
  for (const ProbeExplanation& p : e.probes) addProbeNotes(p, e.notes);
  for (const ExplainedProbe& probe : in.probes) {
    if (!probe.automatic) continue;
    e.notes.push_back("Probe \"" + probe.name + "\": auto chose " + techniqueId(probe.geometry.technique) +
                      " for this object's roughness.");
  }
}

}  // namespace boxprobe
