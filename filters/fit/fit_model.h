// Probe, camera, light and sky for a model without a scene, depending on what kind of model it is.
#pragma once

#include <optional>
#include <string>

#include "filters/core/scene/bounces.h"
#include "filters/fit/box/fit_box.h"
#include "filters/fit/import_guess.h"
#include "filters/fit/model_kind.h"
#include "filters/fit/model_light.h"

namespace boxprobe {

/// Bounces of light in the captures of rooms, whose walls light one another: all. With three, bright rooms are too
/// dark (tests/bench/README.md).
inline constexpr int kRoomBounces = kAllBounces;

/// Settings that override the fit.
struct FitWishes {
  std::optional<ModelKind> kind;
  std::optional<FitLight> light;
  double aspect = 16.0 / 9.0;  ///< aspect ratio of the picture
  std::string studio;          ///< path of the studio's latitude-longitude picture
  BoxFitSettings box;          ///< of the probe's box
};

struct ModelFit {
  ModelSurvey survey;                  ///< its kind is that measured, even if another was requested
  ModelKind kind = ModelKind::Object;  ///< how the model is treated
  FitLight light = FitLight::Studio;
  bool within = false;                ///< the camera is inside the model, and the sky is part of the picture
  bool lightKnown = true;             ///< the lights suit an exposure of 1; else the picture has to be metered
  std::optional<BoxFit> box;          ///< of the probe, if it has one: from the median distances to the fit
  Phrase decided;                     ///< one or two sentences, for messages and `info`
  std::vector<std::string> warnings;  ///< about a size that is unlikely in metres
  std::optional<ImportGuess> guess;   ///< a likely unit and up axis; empty if the file is plausible as it is
};

/// Replaces the probes, cameras, lights and sky of `scene`; cameras of the model files stay, in front. `models` in the
/// order of scene.models. Throws WorkError if the ray tracer cannot take the models.
ModelFit fitModel(Scene& scene, const TriangleRays::Models& models, const FitWishes& wishes = {});

}  // namespace boxprobe
