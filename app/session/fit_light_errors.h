// How wrong the light of a probe's reflections is, and what each face of a fitted box gains of it: angles alone do not
// tell a lamp in the wrong place from a white wall in the wrong place. Called by `boxprobe fit` and by the window's fit
// panel.
#pragma once

#include <array>
#include <optional>

#include "filters/fit/fit_probe.h"

namespace boxprobe {

/// Relative errors of the light that is looked up: the root of the weighted mean of squared differences over that of
/// the right light's squares, over the rays by which a box is rated (fewer of them). The right light is what the
/// probe's origin sees where a reflected ray ends; the other what it sees in the direction that the box gives; both by
/// the path tracer. So the box alone counts: neither texels and bounces of a capture, nor that a surface looks
/// otherwise from elsewhere. Light above five times the mean counts as that, so that no lamp outweighs a room.
struct FitLightErrors {
  double before = 0.0, after = 0.0;
  /// Of the fitted box: how much larger the error is with this face moved back; 0 if the origin moved.
  std::array<double, kFaces> faceGain{};
};

/// `before` is the probe that was fitted. Nothing without light or rays, or if `progress` stopped it. Deterministic.
std::optional<FitLightErrors> fitLightErrors(const Scene& scene, const TriangleRays::Models& models,
                                             ProbeFitter& fitter, const Probe& before, const BoxFit& fit,
                                             const FitProgress& progress = {});

}  // namespace boxprobe
