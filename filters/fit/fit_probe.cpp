// See fit_probe.h.
#include "filters/fit/fit_probe.h"

#include <algorithm>

#include "filters/fit/box/fit_origin.h"

namespace boxprobe {

namespace {

/// Do eyes and probes see the same objects?
bool allAlike(const Scene& scene) {
  return std::all_of(scene.objects.begin(), scene.objects.end(), [](const auto& entry) {
    const ObjectOverride& object = entry.second;
    return object.visible == (object.seenByProbes && !object.dynamic);
  });
}

}  // namespace

ProbeFitter::ProbeFitter(const Scene& scene, const TriangleRays::Models& models)
    : scene_(scene), models_(models), shown_(std::make_shared<TriangleRays>(scene, models)) {
  if (allAlike(scene)) captured_[{}] = shown_;
}

FitPlace ProbeFitter::placeOf(const Probe& probe) {
  std::shared_ptr<const TriangleRays>& captured = captured_[probe.hides];
  if (!captured) captured = std::make_shared<TriangleRays>(scene_, models_, SeenBy::Probes, probe.hides);
  return {*shown_, *captured, scene_.cameras};
}

std::optional<BoxFit> ProbeFitter::fit(const Probe& probe, const BoxFitSettings& settings,
                                       const FitProgress& progress) {
  return fitBox(placeOf(probe), probe, settings, progress);
}

std::optional<BoxFit> ProbeFitter::fitWithOrigin(const Probe& probe, const BoxFitSettings& settings,
                                                 const FitProgress& progress) {
  return proposeOrigin(placeOf(probe), probe, settings, progress);
}

}  // namespace boxprobe
