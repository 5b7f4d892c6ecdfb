#include "filters/reference/truth/truth_trace.h"

#include <glm/matrix.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/reference/trace/picture_rays.h"
#include "filters/reference/trace/visible_normal_lobe.h"
#include "filters/reference/truth/truth_comparison.h"

namespace boxprobe {

namespace {

constexpr int kSide = 4;  // positions along each side of a pixel

/// As the renderer would explain it: what the surface is, and the probe in its box with all of the weight.
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

bool isMirror(const TruthPicture& picture) {
  return picture.roughness < 0.01;
}

ReferencePicture traceTruth(const ReferenceScene& reference, const TruthIndex& index, const TruthPicture& picture,
                            const Camera& camera, int rays, const ReferenceProgress& progress) {
  const int fineness = isMirror(picture) ? kTruthFineness : 1;
  ReferenceSettings settings;
  settings.width = fineness * index.width;
  settings.height = fineness * index.height;
  settings.samplesPerPixel = kSide * kSide;
  settings.raysPerPixel = isMirror(picture) ? kSide * kSide : rays;
  return boxAveraged(reference.render(camera, settings, progress), fineness);
}

ReferencePicture integrateTruth(const ReferenceScene& reference, const Probe& probe, const ReferenceBoxMaps& maps,
                                const TruthIndex& index, const TruthPicture& picture, const Camera& camera, int rays,
                                const ReferenceProgress& progress) {
  const int fineness = isMirror(picture) ? kTruthFineness : 1;
  const int width = fineness * index.width, height = fineness * index.height;
  const RayPlan plan = isMirror(picture) ? RayPlan{1, 1} : planRays(rays, kSide * kSide);
  const ProbeGeometry geometry = probeGeometry(probe, probe.origin);
  const PictureRays view(camera, width, height);
  const auto estimate = [&](int x, int y, int pass) {
    ProgressivePicture::Pixel pixel;
    pixel.exact = true;
    for (int k = 0; k < kSide * kSide; ++k) {
      const double across = x + (k % kSide + 0.5) / kSide, down = y + (k / kSide + 0.5) / kSide;
      const glm::dvec3 eye = view.origin(across, down);
      const auto hit = reference.tracer().firstHit(eye, view.direction(across, down));
      if (!hit || reference.tracer().object(*hit).material.unlit) continue;
      const auto place = static_cast<std::uint64_t>((y * width + x) * kSide * kSide + k);
      const std::uint64_t seed = stirred(stirred(place) + static_cast<std::uint64_t>(pass));
      bool exact = true;
      pixel.color += referenceBoxColor(pointOf(reference, *hit, eye, geometry), maps, plan.raysPerPass, seed, &exact);
      pixel.alpha += 1.0;
      pixel.exact = pixel.exact && exact;
    }
    pixel.color /= kSide * kSide;
    pixel.alpha /= kSide * kSide;
    return pixel;
  };
  ProgressivePicture made(width, height);
  made.run(0, height, plan.passes, estimate, progress);
  return boxAveraged(made.picture(), fineness);
}

}  // namespace boxprobe
