// What is wrong with a box as it stands, face by face, and what one face alone would gain if it moved: quick enough to
// be asked for while a face is dragged. Called by the window; `fitBox` moves all faces together and takes longer.
#pragma once

#include <array>
#include <optional>

#include "filters/fit/box/face_planes.h"
#include "filters/fit/box/fit_box.h"

namespace boxprobe {

struct FaceGauge {
  double meanDegrees = 0.0;  ///< lookup error of the reflections that leave the box through this face
  double share = 0.0;        ///< of all reflections, by weight
  double offset = 0.0;       ///< from the origin, where the box is least wrong if this face alone moves
  double gainDegrees = 0.0;  ///< of the box's mean error, if it moved there; never less than 0
};

/// A reflecting point that somebody sees, where lookups are the most wrong.
struct WorstSpot {
  glm::dvec3 positionWorld{0.0}, eyeWorld{0.0};  ///< of the point and of whoever sees it
  double degrees = 0.0;                          ///< mean lookup error about there
};

struct BoxGauge {
  LookupErrors errors;
  double hidden = 0.0;  ///< share of the reflections whose end the origin does not see
  std::array<FaceGauge, kFaces> faces;
  std::optional<int> worst;       ///< the face that gains the most, if any gains what counts
  std::optional<WorstSpot> spot;  ///< nothing: no eye sees a reflection
};

/// The gain from which a face is worth moving, degrees, for a box of that mean error: less is no more than the noise of
/// the rays.
double countedGain(double meanDegrees);

class BoxGauger {
 public:
  /// Follows the rays of a probe at this origin with this influence; its box may change afterwards. `place` is not
  /// kept.
  BoxGauger(const FitPlace& place, const Probe& probe, int rays = 2048);

  /// Of `probe`, which has the origin it was made with. Nothing where no reflection can be judged, or if `progress`
  /// stopped it. Deterministic.
  std::optional<BoxGauge> measure(const Probe& probe, const FitProgress& progress = {}) const;

 private:
  FaceGauge bestOf(std::size_t face, const OffsetBox& box, double meanDegrees, const LookupRays& rays,
                   const FacePlanes& planes) const;
  std::optional<WorstSpot> worstSpot(const LookupRays& rays, const OffsetBox& box) const;

  ReflectedRays reflected_;
  LookupRays lookups_;            ///< along the world's axes
  std::vector<MetPoint> points_;  ///< likewise
  double reach_ = 0.0;            ///< of the farthest point met
};

/// `probe` with one face where the gauge says.
Probe withFaceAt(const Probe& probe, int face, double offset);

}  // namespace boxprobe
