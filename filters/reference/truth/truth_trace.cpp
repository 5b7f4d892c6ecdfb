#include "filters/reference/truth/truth_trace.h"

#include <algorithm>
#include <functional>
#include <glm/matrix.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/reference/trace/picture_rays.h"
#include "filters/reference/trace/visible_normal_lobe.h"
#include "filters/reference/truth/truth_comparison.h"

namespace boxprobe {

namespace {

/// The distribution of a pixel's rays: random positions in several passes, so that the spread of the passes includes
/// that of the positions. A mirror needs only positions.
struct FloorPlan {
  int passes, positions, raysEach;
};
FloorPlan planFloor(double roughness, int rays) {
  constexpr int kPasses = 8;
  if (roughness < 0.01) return {kPasses, 32, 1};
  const int positions = roughness < 0.2 ? 4 : 2;
  return {kPasses, positions, std::max(rays / (kPasses * positions), 1)};
}

/// The colour at one position, from that many rays.
using FloorEstimate =
    std::function<glm::dvec3(const TracedHit& hit, const glm::dvec3& eye, int rays, std::uint64_t seed)>;

ReferencePicture onFloor(const ReferenceScene& reference, const TruthIndex& index, const TruthPicture& picture,
                         const Camera& camera, const TruthEffort& effort, const FloorEstimate& estimate,
                         const ReferenceProgress& progress) {
  const ImageRgbaF truth = loadTruthPicture(index, picture);
  const PictureRays view(camera, index.width, index.height);
  const FloorPlan plan = planFloor(picture.roughness, effort.rays);
  const auto ofPixel = [&](int x, int y, int pass) {
    ProgressivePicture::Pixel pixel;
    const auto at = static_cast<std::size_t>(y * index.width + x);
    // Steps of 3 and 5 spread the computed pixels over rows and columns.
    pixel.exact = !coveredByFloor(truth, at) || (3 * x + 5 * y) % effort.stride != 0;
    if (pixel.exact) return pixel;
    const std::uint64_t seed = hashBits(hashBits(at) + static_cast<std::uint64_t>(pass));
    const ShiftedPoints places(seed);
    for (int k = 0; k < plan.positions; ++k) {
      const double across = x + places[k].x, down = y + places[k].y;
      const glm::dvec3 eye = view.origin(across, down);
      const auto hit = reference.tracer().firstHit(eye, view.direction(across, down));
      if (!hit || reference.tracer().object(*hit).material.unlit) continue;
      pixel.color += estimate(*hit, eye, plan.raysEach, hashBits(seed + static_cast<std::uint64_t>(k)));
      pixel.alpha += 1.0;
    }
    pixel.color /= plan.positions;
    pixel.alpha /= plan.positions;
    return pixel;
  };
  ProgressivePicture made(index.width, index.height);
  made.run({0, 0, index.width, index.height}, plan.passes, ofPixel, progress);
  return made.picture();
}

/// As the renderer would explain it: the surface, and the probe of its box with full weight.
LitPoint pointOf(const ReferenceScene& reference, const TracedHit& hit, const glm::dvec3& eye,
                 const ProbeGeometry& geometry) {
  LitPoint point;
  point.hit = true;
  point.surface = reference.tracer().surface(hit, eye);
  ProbeAtPoint probe;
  probe.weight = 1.0f;
  probe.intensity = geometry.intensity;
  probe.captured = true;
  probe.worldFromProbe = geometry.worldFromProbe;
  probe.mapFromProbe = geometry.mapFromProbe;
  probe.positionProbe = glm::vec3(glm::transpose(geometry.worldFromProbe) * (hit.positionWorld - geometry.originWorld));
  probe.boxMin = geometry.boxMin;
  probe.boxMax = geometry.boxMax;
  point.probes = {probe};
  return point;
}

}  // namespace

ReferencePicture traceTruth(const ReferenceScene& reference, const TruthIndex& index, const TruthPicture& picture,
                            const Camera& camera, const TruthEffort& effort, const ReferenceProgress& progress) {
  const auto estimate = [&](const TracedHit& hit, const glm::dvec3& eye, int rays, std::uint64_t seed) {
    return reference.reflectedFrom(reference.tracer().surface(hit, eye), reference.tracer().awayFrom(hit),
                                   RaySees::Probes, rays, seed);
  };
  return onFloor(reference, index, picture, camera, effort, estimate, progress);
}

ReferencePicture integrateTruth(const ReferenceScene& reference, const Probe& probe, const ReferenceBoxMaps& maps,
                                const TruthIndex& index, const TruthPicture& picture, const Camera& camera,
                                const TruthEffort& effort, const ReferenceProgress& progress) {
  const ProbeGeometry geometry = probeGeometry(probe, probe.origin);
  const auto estimate = [&](const TracedHit& hit, const glm::dvec3& eye, int rays, std::uint64_t seed) {
    return referenceBoxColor(pointOf(reference, hit, eye, geometry), maps, rays, seed);
  };
  return onFloor(reference, index, picture, camera, effort, estimate, progress);
}

}  // namespace boxprobe
