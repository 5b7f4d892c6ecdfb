// Fits boxes to the probes of a scene. Called by `boxprobe fit`, and by whatever fits one while its user waits: build a
// ProbeFitter and call fit() in a thread of its own, with a progress that asks whether to go on; one at a time.
#pragma once

#include <map>
#include <memory>

#include "filters/fit/box/fit_box.h"
#include "filters/fit/rays/triangle_rays.h"

namespace boxprobe {

class ProbeFitter {
 public:
  /// `models` in the order of scene.models; both are copied or shared. Builds the ray tracer's structures, which takes
  /// about a second for a million triangles. Throws WorkError where the ray tracer cannot take the models.
  ProbeFitter(const Scene& scene, const TriangleRays::Models& models);

  /// Fits the box of `probe`, which need not be in the scene, to what it sees there. Nothing, if `progress` stopped it.
  std::optional<BoxFit> fit(const Probe& probe, const BoxFitSettings& settings = {}, const FitProgress& progress = {});
  /// As proposeOrigin.
  std::optional<BoxFit> fitWithOrigin(const Probe& probe, const BoxFitSettings& settings = {},
                                      const FitProgress& progress = {});

  /// What eyes, and a probe that hides what `probe` hides, see. Valid as long as this is.
  FitPlace placeOf(const Probe& probe);

 private:
  Scene scene_;
  TriangleRays::Models models_;
  std::shared_ptr<const TriangleRays> shown_;
  std::map<std::vector<std::string>, std::shared_ptr<const TriangleRays>> captured_;  ///< by the nodes left out
};

}  // namespace boxprobe
