// The error of a box, face by face, and what moving a single face would gain. Fast enough to be evaluated while a face
// is dragged; `fitBox` moves all faces together and takes longer.
#pragma once

#include <array>
#include <optional>

#include "filters/fit/box/face_planes.h"
#include "filters/fit/box/fit_box.h"

namespace boxprobe {

struct FaceGauge {
  double meanDegrees = 0.0;  ///< lookup error of the reflections that leave the box through this face
  double share = 0.0;        ///< of all reflections, weighted
  double offset = 0.0;       ///< from the origin: the best position if only this face moves
  double gainDegrees = 0.0;  ///< reduction of the box's mean error if it moved there; at least 0
};

/// The visible reflecting point where lookups are the most wrong.
struct WorstSpot {
  glm::dvec3 positionWorld{0.0}, eyeWorld{0.0};  ///< the point, and the eye that sees it
  double degrees = 0.0;                          ///< mean lookup error around the point
};

struct BoxGauge {
  LookupErrors errors;
  double hidden = 0.0;  ///< share of the reflections whose end the origin does not see
  std::array<FaceGauge, kFaces> faces;
  std::optional<int> worst;       ///< the face that gains the most, if that is significant
  std::optional<WorstSpot> spot;  ///< empty: no eye sees a reflection
};

/// The least significant gain in degrees, for a box of that mean error: less is noise of the rays.
double countedGain(double meanDegrees);

class BoxGauger {
 public:
  /// Traces the rays of a probe with this origin and influence; its box may change afterwards. Keeps no reference to
  /// `place`.
  BoxGauger(const FitPlace& place, const Probe& probe, int rays = kBoxRays);

  /// `probe` must have the origin given to the constructor. Nothing if no reflection can be judged, or if `progress`
  /// stopped it. Deterministic.
  std::optional<BoxGauge> measure(const Probe& probe, const FitProgress& progress = {}) const;

 private:
  FaceGauge bestOf(std::size_t face, const OffsetBox& box, double meanDegrees, const LookupRays& rays,
                   const FacePlanes& planes) const;
  std::optional<WorstSpot> worstSpot(const LookupRays& rays, const OffsetBox& box,
                                     const std::array<FaceGauge, kFaces>& faces) const;

  ReflectedRays reflected_;
  LookupRays lookups_;            ///< along the world's axes
  std::vector<MetPoint> points_;  ///< along the world's axes
  double reach_ = 0.0;            ///< distance of the farthest hit
};

/// `probe` with one face moved to `offset`.
Probe withFaceAt(const Probe& probe, int face, double offset);

}  // namespace boxprobe
