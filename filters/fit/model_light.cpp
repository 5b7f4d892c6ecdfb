// See model_light.h.
#include "filters/fit/model_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace boxprobe {

const char* fitLightId(FitLight light) {
  constexpr const char* kIds[] = {"file", "studio", "ceiling", "openings", "daylight"};
  return kIds[static_cast<int>(light)];
}

const std::vector<FitLight>& allFitLights() {
  static const std::vector<FitLight> all = {FitLight::File, FitLight::Studio, FitLight::Ceiling, FitLight::Openings,
                                            FitLight::Daylight};
  return all;
}

std::vector<Light> ceilingLights(const Probe& probe, const StandingPoint& stand) {
  constexpr double kFloorIrradiance = 2.0;  // below a lamp; a white floor then has a radiance of 0.64
  const Box& box = probe.box;
  const double height = std::max(stand.height, 1e-9), lampHeight = 0.75 * height;
  const auto lampsAlong = [&](double length) { return std::clamp(std::lround(length / (2.5 * height)), 1L, 2L); };
  const long across = lampsAlong(box.size().x), along = lampsAlong(box.size().z);
  std::vector<Light> lights;
  for (long x = 0; x < across; ++x) {
    for (long z = 0; z < along; ++z) {
      Light lamp;
      lamp.type = LightType::Point;
      const double shareX = (static_cast<double>(x) + 0.5) / static_cast<double>(across);
      const double shareZ = (static_cast<double>(z) + 0.5) / static_cast<double>(along);
      lamp.position = {box.min.x + shareX * box.size().x, stand.floor + lampHeight, box.min.z + shareZ * box.size().z};
      lamp.color = glm::vec3(1.0f, 0.95f, 0.88f);
      lamp.intensity = static_cast<float>(kFloorIrradiance * lampHeight * lampHeight);
      lamp.radius = 0.1 * height;
      lights.push_back(lamp);
    }
  }
  return lights;
}

std::vector<Light> openingLights(const TriangleRays& rays, const Probe& probe) {
  constexpr int kRays = 4096;
  constexpr double kOpen = 0.008;
  struct Side {
    double rays = 0.0, open = 0.0, area = 0.0;
    glm::dvec3 middle{0.0};
  };
  std::array<Side, 6> sides;
  for (const glm::dvec3& direction : fibonacciDirections(kRays)) {
    // Where, and through which face, the ray leaves the box.
    double leaves = 1e300;
    std::size_t face = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (direction[axis] == 0.0) continue;
      const bool up = direction[axis] > 0.0;
      const double distance = ((up ? probe.box.max : probe.box.min)[axis] - probe.origin[axis]) / direction[axis];
      if (distance < leaves) {
        leaves = distance;
        face = static_cast<std::size_t>(2 * axis + (up ? 1 : 0));
      }
    }
    Side& side = sides[face];
    side.rays += 1.0;
    if (rays.first(probe.origin, direction)) continue;
    side.open += 1.0;
    const double cosine = std::abs(direction[static_cast<int>(face / 2)]);
    side.area += 4.0 * std::acos(-1.0) / kRays * leaves * leaves / std::max(cosine, 0.05);
    side.middle += probe.origin + leaves * direction;
  }
  const SkyGradient sky;
  const float radiance = std::max({sky.horizon.r, sky.horizon.g, sky.horizon.b});
  std::vector<Light> lights;
  for (std::size_t face = 0; face < sides.size(); ++face) {
    const Side& side = sides[face];
    const bool below = face == 2;
    if (below || side.open < kOpen * side.rays || side.open < 4.0) continue;
    glm::dvec3 inward(0.0);
    inward[static_cast<int>(face / 2)] = face % 2 == 0 ? 1.0 : -1.0;
    Light light;
    light.type = LightType::Spot;
    // As far behind the opening as it is wide: near a point light, the window frame would be overexposed.
    light.position = side.middle / side.open - std::sqrt(side.area) * inward;
    light.direction = inward - (std::abs(inward.y) > 0.5 ? glm::dvec3(0.0) : glm::dvec3(0.0, 0.35, 0.0));
    light.color = sky.horizon / radiance;
    light.intensity = static_cast<float>(side.area) * radiance;
    light.innerConeDegrees = 30.0;
    light.outerConeDegrees = 75.0;
    light.radius = 0.5 * std::sqrt(side.area);
    lights.push_back(light);
  }
  return lights;
}

std::vector<Light> sunLight() {
  Light sun;
  const double elevation = glm::radians(50.0), azimuth = glm::radians(-35.0);
  sun.direction = -glm::dvec3(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                              std::cos(azimuth) * std::cos(elevation));
  sun.color = glm::vec3(1.0f, 0.95f, 0.86f);
  sun.intensity = 2.5f;
  return {sun};
}

}  // namespace boxprobe
