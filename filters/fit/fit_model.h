// Probe, camera, light and sky for a model that was opened without a scene, by what it is. Called by app/session for a
// bare model and by the window when the user decides otherwise; knows no files but the studio's name.
#pragma once

#include <optional>
#include <string>

#include "filters/fit/box/fit_box.h"
#include "filters/fit/import_guess.h"
#include "filters/fit/model_kind.h"
#include "filters/fit/model_light.h"

namespace boxprobe {

/// What is not left to the fit.
struct FitWishes {
  std::optional<ModelKind> kind;
  std::optional<FitLight> light;
  double aspect = 16.0 / 9.0;  ///< of the picture the camera is for: width over height
  std::string studio;          ///< latitude-longitude picture of the studio
  BoxFitSettings box;          ///< of the probe's box
};

struct ModelFit {
  ModelSurvey survey;                  ///< its kind is what the rays say, wished or not
  ModelKind kind = ModelKind::Object;  ///< what the model is treated as
  FitLight light = FitLight::Studio;
  bool within = false;                ///< the camera stands in it and the sky is part of the picture
  bool lightKnown = true;             ///< made for an exposure of 1; else the picture is to be measured
  std::optional<BoxFit> box;          ///< of the probe, if it has one: from the median distances to the fit
  std::string decided;                ///< a sentence or two, for messages and `info`
  std::vector<std::string> warnings;  ///< of a size that is unlikely in metres
  std::optional<ImportGuess> guess;   ///< how the file may be meant; nothing where it is plausible as it is
};

/// Gives `scene` probes, cameras, lights and a sky in place of those it has; cameras of the model files are kept first.
/// `models` in the order of scene.models. Throws WorkError where the ray tracer cannot take them.
ModelFit fitModel(Scene& scene, const TriangleRays::Models& models, const FitWishes& wishes = {});

}  // namespace boxprobe
