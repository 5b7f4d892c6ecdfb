#include "filters/core/geometry/mirror_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace boxprobe {

namespace {

glm::dvec3 mirrored(const glm::dvec3& direction, const glm::dvec3& normal) {
  return direction - 2.0 * glm::dot(direction, normal) * normal;
}

glm::dvec4 row(const glm::dmat4& m, int i) {
  return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

void setRow(glm::dmat4& m, int i, const glm::dvec4& values) {
  for (int column = 0; column < 4; ++column) m[column][i] = values[column];
}

/// Sutherland-Hodgman: the part of a polygon where dot(plane, p) >= 0.
std::vector<glm::dvec4> clipped(const std::vector<glm::dvec4>& polygon, const glm::dvec4& plane) {
  std::vector<glm::dvec4> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec4 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = glm::dot(plane, a), db = glm::dot(plane, b);
    if (da >= 0.0) result.push_back(a);
    if ((da >= 0.0) != (db >= 0.0)) result.push_back(a + (b - a) * (da / (da - db)));
  }
  return result;
}

/// The projection followed by a crop to `rect`: its x and y range from -1 to 1.
glm::dmat4 cropped(const glm::dmat4& clipFromView, const PictureView& view, const MirrorRect& rect) {
  const auto axis = [&](int i, int first, int size, int whole) {
    const double low = 2.0 * first / whole - 1.0, high = 2.0 * (first + size) / whole - 1.0;
    const double scale = 2.0 / (high - low);
    return scale * row(clipFromView, i) - 0.5 * scale * (high + low) * row(clipFromView, 3);
  };
  glm::dmat4 result = clipFromView;
  setRow(result, 0, axis(0, rect.x, rect.width, view.width));
  setRow(result, 1, axis(1, rect.y, rect.height, view.height));
  return result;
}

}  // namespace

glm::dmat4 PictureView::viewFromEye() const {
  const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
  glm::dmat4 m(1.0);
  setRow(m, 0, glm::dvec4(right, 0.0));
  setRow(m, 1, glm::dvec4(glm::cross(right, forward), 0.0));
  setRow(m, 2, glm::dvec4(-forward, 0.0));
  return m;
}

bool facesEye(MirrorPlane& plane, const PictureView& view) {
  const double facing =
      view.parallel ? -glm::dot(view.forward, plane.normal) : glm::dot(view.eye - plane.center, plane.normal);
  if (facing < 0.0 && plane.bothSides) {
    plane.normal = -plane.normal;
    return true;
  }
  // An eye in the plane sees nothing of it, and the mirrored eye would lie on its own near plane.
  const double size = glm::distance(plane.corners[0], plane.corners[2]);
  return facing > 1.0e-6 * (view.parallel ? 1.0 : size);
}

std::vector<glm::dvec2> visiblePart(const MirrorPlane& plane, const PictureView& view) {
  const glm::dmat4 clipFromEye = view.clipFromView * view.viewFromEye();
  std::vector<glm::dvec4> polygon;
  for (const glm::dvec3& corner : plane.corners) polygon.push_back(clipFromEye * glm::dvec4(corner - view.eye, 1.0));
  // Clip in front of the eye first: the side planes do not exclude what lies behind it. Relative to the corners'
  // distance.
  double reach = 0.0;
  for (const glm::dvec4& corner : polygon) reach = std::max(reach, std::fabs(corner.w));
  for (glm::dvec4& corner : polygon) corner.w -= 1.0e-6 * reach;
  polygon = clipped(polygon, {0.0, 0.0, 0.0, 1.0});
  for (glm::dvec4& corner : polygon) corner.w += 1.0e-6 * reach;
  for (const glm::dvec4& side :
       {glm::dvec4(1, 0, 0, 1), glm::dvec4(-1, 0, 0, 1), glm::dvec4(0, 1, 0, 1), glm::dvec4(0, -1, 0, 1)}) {
    polygon = clipped(polygon, side);
  }
  std::vector<glm::dvec2> result;
  for (const glm::dvec4& corner : polygon) result.emplace_back(corner.x / corner.w, corner.y / corner.w);
  return result.size() < 3 ? std::vector<glm::dvec2>() : result;
}

double areaOf(const std::vector<glm::dvec2>& polygon, const PictureView& view) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return 0.5 * std::fabs(twice) * 0.25 * view.width * view.height;
}

MirrorRect mirroredRect(const std::vector<glm::dvec2>& polygon, const PictureView& view, double margin) {
  glm::dvec2 low(1.0), high(-1.0);
  for (const glm::dvec2& p : polygon) {
    const glm::dvec2 flipped(-p.x, p.y);  // left and right are swapped
    low = glm::min(low, flipped);
    high = glm::max(high, flipped);
  }
  const auto side = [margin](double from, double to, int whole, int& first, int& size) {
    const double a = 0.5 * (from + 1.0) * whole - margin, b = 0.5 * (to + 1.0) * whole + margin;
    first = static_cast<int>(std::floor(a / kRectGrid)) * kRectGrid;
    size = static_cast<int>(std::ceil(b / kRectGrid)) * kRectGrid - first;
    size = std::max(size, kRectGrid);
  };
  MirrorRect rect;
  side(low.x, high.x, view.width, rect.x, rect.width);
  side(low.y, high.y, view.height, rect.y, rect.height);
  return rect;
}

PictureView mirroredView(const MirrorPlane& plane, const PictureView& view, const MirrorRect& rect,
                         double farDistance) {
  PictureView result = view;
  const double height = glm::dot(view.eye - plane.center, plane.normal);
  result.eye = view.eye - 2.0 * height * plane.normal;
  result.forward = mirrored(view.forward, plane.normal);
  result.up = mirrored(view.up, plane.normal);
  // A far plane of its own: what the mirror shows is farther from the mirrored eye than the scene is from the eye. The
  // near plane is replaced below; here it only has to be valid.
  glm::dmat4 projection = view.clipFromView;
  const double far = farDistance, near = 1.0e-3 * farDistance;
  if (view.parallel) {
    setRow(projection, 2, {0.0, 0.0, -2.0 / (far - near), -(far + near) / (far - near)});
  } else {
    setRow(projection, 2, {0.0, 0.0, -(far + near) / (far - near), -2.0 * far * near / (far - near)});
  }
  const glm::dvec3 normalView(result.viewFromEye() * glm::dvec4(plane.normal, 0.0));
  projection = withNearPlane(projection, glm::dvec4(normalView, glm::dot(plane.normal, result.eye - plane.center)));
  result.clipFromView = cropped(projection, view, rect);
  result.width = rect.width;
  result.height = rect.height;
  return result;
}

glm::dmat4 withNearPlane(const glm::dmat4& clipFromView, const glm::dvec4& planeView) {
  const glm::dmat4 viewFromClip = glm::inverse(clipFromView);
  const glm::dvec4 planeClip = glm::transpose(viewFromClip) * planeView;
  const auto sign = [](double x) { return x < 0.0 ? -1.0 : 1.0; };
  // The far plane passes through the farthest visible corner of the frustum, to use the depth range fully.
  const glm::dvec4 corner = viewFromClip * glm::dvec4(sign(planeClip.x), sign(planeClip.y), 1.0, 1.0);
  const glm::dvec4 last = row(clipFromView, 3);
  glm::dmat4 result = clipFromView;
  setRow(result, 2, planeView * (2.0 * glm::dot(last, corner) / glm::dot(planeView, corner)) - last);
  return result;
}

}  // namespace boxprobe
