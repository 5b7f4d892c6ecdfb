// Fits the projection box and yaw of one probe to what its capture origin sees and to where reflected rays end. One
// call without state, which reports progress and can be stopped.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/base/phrase.h"
#include "filters/fit/box/box_search.h"
#include "filters/fit/box/lookup_rays.h"

namespace boxprobe {

/// By how many rays a box is rated, wherever its error is said: two counts would give two figures of one box.
inline constexpr int kBoxRays = 4096;

struct BoxFitSettings {
  std::array<bool, kFaces> faces{true, true, true, true, true, true};  ///< which faces may move
  bool yaw = true;                                                     ///< may the box turn about +y?
  int rays = kBoxRays;
};

enum class FitOutcome {
  Fitted,  ///< a better box was found
  Kept,    ///< no better box: it stays
  Open,    ///< there are no walls to fit to: the box stays
  Inside,  ///< the origin is inside a wall: the box stays
};

struct FaceFit {
  double gainDegrees = 0.0;  ///< of the mean error, by this face alone: what moving it back would lose
  double sensitivity = 0.0;  ///< degrees of mean error per scene unit of displacement
  bool free = false;         ///< its position hardly matters
};

struct BoxFit {
  FitOutcome outcome = FitOutcome::Kept;
  Probe probe;  ///< the fitted probe, or a copy of the given one
  LookupErrors before, after;
  std::array<FaceFit, kFaces> faces;
  double hiddenBefore = 0.0;    ///< share of the reflections whose end the origin did not see
  double hidden = 0.0;          ///< the same for the result; different only if the origin moved
  double open = 0.0;            ///< share of the reflections that show the sky
  double seconds = 0.0;         ///< duration
  std::vector<Phrase> remarks;  ///< sentences without a full stop
};

/// Deterministic. Nothing if `progress` stopped it. Lengths in scene units, right-handed, +y up.
std::optional<BoxFit> fitBox(const FitPlace& place, const Probe& probe, const BoxFitSettings& settings = {},
                             const FitProgress& progress = {});

/// The box of `probe` as offsets from its capture origin along the box's axes.
OffsetBox offsetBox(const Probe& probe);
/// `probe` with that box, whose yaw is relative to the axes of `rotationDegrees`. A separate influence box keeps the
/// space that it covers.
Probe withOffsetBox(const Probe& probe, const OffsetBox& box, const glm::dvec3& rotationDegrees);

/// The influence box, along the axes of the probe's box, that contains a box along the world's axes.
Box turnedInfluence(const Box& upright, const Probe& probe);

/// The errors of a probe's box, by the same rays as fitBox; `turn` as in reflectedRays.
LookupErrors boxErrors(const FitPlace& place, const Probe& probe, int rays = kBoxRays, double turn = 0.0);

}  // namespace boxprobe
