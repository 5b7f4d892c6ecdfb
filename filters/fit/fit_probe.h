// Fits boxes to the probes of a scene. To fit in the background, build a ProbeFitter and call fit() in a thread, with a
// progress callback that can stop it; not thread-safe.
#pragma once

#include <map>
#include <memory>

#include "filters/fit/box/fit_box.h"
#include "filters/fit/rays/triangle_rays.h"

namespace boxprobe {

class ProbeFitter {
 public:
  /// `models` in the order of scene.models; scene and models are copied or shared. Builds the ray tracer's structures,
  /// about a second per million triangles. Throws WorkError if the ray tracer cannot take the models.
  ProbeFitter(const Scene& scene, const TriangleRays::Models& models);

  /// Fits the box of `probe`, which need not be in the scene. Nothing if `progress` stopped it.
  std::optional<BoxFit> fit(const Probe& probe, const BoxFitSettings& settings = {}, const FitProgress& progress = {});
  /// As proposeOrigin().
  std::optional<BoxFit> fitWithOrigin(const Probe& probe, const BoxFitSettings& settings = {},
                                      const FitProgress& progress = {});

  /// The scene for a probe that hides what `probe` hides. Valid as long as this object.
  FitPlace placeOf(const Probe& probe);

 private:
  Scene scene_;
  TriangleRays::Models models_;
  std::shared_ptr<const TriangleRays> shown_;
  std::map<std::vector<std::string>, std::shared_ptr<const TriangleRays>> captured_;  ///< by the hidden nodes
};

}  // namespace boxprobe
