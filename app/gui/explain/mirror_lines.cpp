// See mirror_lines.h.
#include "app/gui/explain/mirror_lines.h"

#include <glm/geometric.hpp>

#include "filters/core/base/errors.h"
#include "filters/core/geometry/mirror_plane.h"

namespace boxprobe {

namespace {

/// How far beyond the mirror its edges are drawn, in distances of the eye from it.
constexpr double kBeyond = 1.0;

const glm::dvec3 kPortal = HandleColors::display(0x46c8e6), kRay = HandleColors::display(0xff78c8);

void addPortal(std::vector<glm::dvec3>& segments, const MirrorPlane& plane, const glm::dvec3& eye,
               const glm::dvec3& forward, bool parallel) {
  const double height = glm::dot(eye - plane.center, plane.normal);
  const glm::dvec3 mirrored = eye - 2.0 * height * plane.normal;
  const glm::dvec3 along = forward - 2.0 * glm::dot(forward, plane.normal) * plane.normal;
  for (std::size_t i = 0; i < plane.corners.size(); ++i) {
    const glm::dvec3& corner = plane.corners[i];
    const glm::dvec3& next = plane.corners[(i + 1) % plane.corners.size()];
    segments.insert(segments.end(), {corner, next});
    // From the mirrored eye through the corner, or along the view that has no eye.
    const glm::dvec3 ray = parallel ? along * height : corner - mirrored;
    segments.insert(segments.end(), {parallel ? corner - ray : mirrored, corner + kBeyond * ray});
  }
  if (!parallel) segments.insert(segments.end(), {eye, mirrored});
}

}  // namespace

MirrorLines::MirrorLines(vtkRenderer* renderer)
    : portals_(renderer, {kPortal, 1.5, 0.8, true}), rays_(renderer, {kRay, 2.5, 1.0, true}) {
  setShown(false);
}

void MirrorLines::setShown(bool shown) {
  shown_ = shown;
  portals_.setVisible(shown);
  rays_.setVisible(shown);
}

void MirrorLines::explain(const Explanation* e) {
  ray_.clear();
  if (e == nullptr || !e->mirror || e->mirror->coverage <= 0.0f) return;
  const glm::dvec3 met =
      e->surface.positionWorld + static_cast<double>(e->mirror->hitDistance) * glm::dvec3(e->reflectionWorld);
  ray_ = {e->surface.eyeWorld, e->surface.positionWorld, e->surface.positionWorld, met};
}

void MirrorLines::update(const Scene& scene, const std::vector<std::string>& drawn, const glm::dvec3& eyeWorld,
                         const glm::dvec3& forwardWorld, bool parallel) {
  if (!shown_) return;
  std::vector<glm::dvec3> segments;
  for (const std::string& node : drawn) {
    try {
      if (const auto plane = mirrorPlane(scene, models_, node)) {
        addPortal(segments, *plane, eyeWorld, forwardWorld, parallel);
      }
    } catch (const InputError&) {
      continue;  // said where it is switched on
    }
  }
  portals_.setSegments(segments);
  rays_.setSegments(ray_);
  lines_ = (segments.size() + ray_.size()) / 2;
  setShown(true);
}

}  // namespace boxprobe
