#include "filters/reference/trace/lamp_triangles.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {

namespace {

// An object this many times as bright as the mean over all surfaces is a lamp.
constexpr double kStandsOut = 4.0;

double brightness(const TracedObject& object) {
  const Material& m = object.material;
  const glm::vec3 light = m.unlit ? glm::vec3(m.baseColor) : m.emissive;
  return static_cast<double>(std::max({light.x, light.y, light.z}));
}

}  // namespace

LampTriangles::LampTriangles(const TriangleScene& scene)
    : objects_(scene.objects.size()), perArea_(scene.objects.size()) {
  const auto forEach = [&](const TracedObject& object, const auto& each) {
    for (std::size_t i = 0; i + 2 < object.indices.size(); i += 3) {
      const auto at = [&](std::size_t k) { return glm::dvec3(object.positions[object.indices[i + k]]); };
      each(at(0), at(1) - at(0), at(2) - at(0));
    }
  };
  std::vector<double> areas;
  double light = 0.0, area = 0.0;
  for (const TracedObject& object : scene.objects) {
    double sum = 0.0;
    if (object.inProbes || object.inPicture) {
      forEach(object, [&](const glm::dvec3&, const glm::dvec3& a, const glm::dvec3& b) {
        sum += 0.5 * glm::length(glm::cross(a, b));
      });
    }
    areas.push_back(sum);
    area += sum;
    light += sum * brightness(object);
  }
  if (!(light > 0.0)) return;
  double power = 0.0;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    objects_[i] = areas[i] > 0.0 && brightness(scene.objects[i]) > kStandsOut * light / area;
    if (objects_[i]) power += areas[i] * brightness(scene.objects[i]);
  }
  double before = 0.0;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (!objects_[i]) continue;
    perArea_[i] = brightness(scene.objects[i]) / power;
    std::uint32_t number = 0;
    forEach(scene.objects[i], [&](const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b) {
      before += 0.5 * glm::length(glm::cross(a, b)) * perArea_[i];
      triangles_.push_back({scene.anchorWorld + corner, a, b, static_cast<int>(i), number++, before});
    });
  }
}

LampTriangles::Towards LampTriangles::towards(const glm::dvec3& from, const glm::dvec2& u) const {
  const auto found = std::lower_bound(triangles_.begin(), triangles_.end(), u.x,
                                      [](const Triangle& t, double share) { return t.cumulated < share; });
  const auto at = std::min<std::size_t>(static_cast<std::size_t>(found - triangles_.begin()), triangles_.size() - 1);
  const Triangle& t = triangles_[at];
  const double first = at > 0 ? triangles_[at - 1].cumulated : 0.0, width = t.cumulated - first;
  // The remainder of the first number selects the place in the triangle.
  const double root = std::sqrt(width > 0.0 ? std::clamp((u.x - first) / width, 0.0, 1.0) : 0.5);
  const glm::dvec3 way = t.corner + root * ((1.0 - u.y) * t.along + u.y * t.up) - from;
  const double length = glm::length(way);
  return {length > 0.0 ? way / length : glm::dvec3(0.0), t.object, t.number};
}

double LampTriangles::density(const TracedHit& hit) const {
  if (!shines(hit)) return 0.0;
  return perArea_[static_cast<std::size_t>(hit.object)] * hit.distance * hit.distance / std::max(hit.cosine, 1.0e-9);
}

}  // namespace boxprobe
