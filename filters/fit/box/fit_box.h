// The box that a place asks for: projection box and yaw of one probe, fitted to what its capture origin sees and to
// where reflected rays end. Called by fit_model, by `boxprobe fit` and by whatever fits in the background: it is one
// call without state, reports progress and can be stopped.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "filters/fit/box/box_search.h"
#include "filters/fit/box/lookup_rays.h"

namespace boxprobe {

struct BoxFitSettings {
  std::array<bool, kFaces> faces{true, true, true, true, true, true};  ///< which may move
  bool yaw = true;                                                     ///< may the box turn about +y?
  int rays = 4096;
};

enum class FitOutcome {
  Fitted,  ///< a better box was found
  Kept,    ///< none was: the box stays
  Open,    ///< there are no walls to fit to: the box stays
  Inside,  ///< the origin is inside of a wall: the box stays
};

struct FaceFit {
  double gainDegrees = 0.0;  ///< of the mean error, by this face alone: what is lost if it goes back
  double sensitivity = 0.0;  ///< degrees of the mean error for a scene unit that the face is off
  bool free = false;         ///< it hardly matters where this face lies
};

struct BoxFit {
  FitOutcome outcome = FitOutcome::Kept;
  Probe probe;  ///< the fitted one; without a better box the one given
  LookupErrors before, after;
  std::array<FaceFit, kFaces> faces;
  double hiddenBefore = 0.0;         ///< share of the reflections whose end the origin did not see
  double hidden = 0.0;               ///< whose end it does not see now; the same unless the origin was moved
  double open = 0.0;                 ///< share of the reflections that show the sky
  double seconds = 0.0;              ///< that it took
  std::vector<std::string> remarks;  ///< sentences without a full stop
};

/// Deterministic. Nothing, if `progress` stopped it. Sizes in scene units, right-handed, +y up.
std::optional<BoxFit> fitBox(const FitPlace& place, const Probe& probe, const BoxFitSettings& settings = {},
                             const FitProgress& progress = {});

/// The box of `probe` as offsets from its capture origin along the box's axes.
OffsetBox offsetBox(const Probe& probe);
/// `probe` with the box that `box` is; its yaw turns it against the axes that `rotationDegrees` stands for. An
/// influence of its own keeps the space that it covers.
Probe withOffsetBox(const Probe& probe, const OffsetBox& box, const glm::dvec3& rotationDegrees);

/// The influence box, along the axes of the probe's box, that holds a box along the world's axes.
Box turnedInfluence(const Box& upright, const Probe& probe);

/// How wrong the box of a probe is, by the same rays as fitBox; `turn` as reflectedRays takes it.
LookupErrors boxErrors(const FitPlace& place, const Probe& probe, int rays = 4096, double turn = 0.0);

}  // namespace boxprobe
