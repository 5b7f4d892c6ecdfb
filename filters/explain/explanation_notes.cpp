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

void addProbeNotes(const ProbeExplanation& p, std::vector<Phrase>& notes) {
  if (p.weight <= 0.0f) {
    notes.push_back(Phrase::tr("Probe \"%1\": its weight is 0 here, so it is not sampled.").arg(p.name));
    return;
  }
  if (!p.captured) {
    notes.push_back(Phrase::tr("Probe \"%1\" has not been captured yet: it reflects nothing.").arg(p.name));
  }
  if (!p.hitDistance) {
    notes.push_back(Phrase::tr("Probe \"%1\": technique %2 has no box to hit, so hit point and distance are undefined; "
                               "the surroundings are taken to be infinitely far away.")
                        .arg(p.name)
                        .arg(p.technique));
  }
  if (!p.slabFactors) return;
  const float skin = 1.0e-4f * glm::length(p.boxMax - p.boxMin);
  if (!inside(glm::vec3(0.0f), p.boxMin, p.boxMax, 0.0f)) {
    notes.push_back(Phrase::tr("Probe \"%1\": the capture origin lies outside the projection box, so a part of the "
                               "sampled surfaces was never captured from inside the box.")
                        .arg(p.name));
  }
  if (!inside(p.positionProbe, p.boxMin, p.boxMax, skin)) {
    notes.push_back(Phrase::tr("Probe \"%1\": the point lies outside the projection box; distances to planes behind it "
                               "count as 0 and the hit is pulled on to the box.")
                        .arg(p.name));
  }
  if (!p.trueDistance && p.captured) {
    notes.push_back(
        Phrase::tr("Probe \"%1\": its distances do not give the true hit here (open sky, or hidden from the "
                   "capture origin).")
            .arg(p.name));
  }
}

}  // namespace

void addNotes(Explanation& e, const ExplainInput& in) {
  const SurfacePoint& s = e.surface;
  if (s.opacity < 0.999f) {
    e.notes.push_back(
        Phrase::tr("The surface is translucent. What lies behind it shows through and is not explained here."));
  }
  if (e.glass && e.glass->stands > 0.0f) {
    e.notes.push_back(
        Phrase::tr("Light passes the glass nearly straight: %1 % of what the picture shows here is what is "
                   "drawn behind, in place of the lookup, and is not part of this.")
            .arg(fixedText(100.0 * double(e.glass->stands), 1)));
  } else if (e.glass && e.glass->reflectance < 1.0f) {
    e.notes.push_back(Phrase::tr(
        "Where something opaque is drawn along the refracted ray, the picture shows that in place of this lookup."));
  }
  if (e.probes.empty()) {
    e.notes.push_back(Phrase::tr(
        "No probe lights this object, because none reaches it or its probeMode is off. The current sky shows "
        "through, not box-projected."));
  }
  for (const ProbeExplanation& p : e.probes) addProbeNotes(p, e.notes);
  for (const ExplainedProbe& probe : in.probes) {
    if (!probe.automatic) continue;
    e.notes.push_back(Phrase::tr("Probe \"%1\": auto chose %2 for this object's roughness.")
                          .arg(probe.name)
                          .arg(techniqueId(probe.geometry.technique)));
  }
}

}  // namespace boxprobe
