#include "filters/io/mesh/far_positions.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_limits.h"

namespace boxprobe {

namespace {

constexpr double kFar = 4.0;

}  // namespace

NearPositions nearPositions(const std::vector<glm::dvec3>& positions, const std::string& place) {
  NearPositions result;
  glm::dvec3 low(limits::kNumber), high(-limits::kNumber);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::fabs(positions[i][axis]) <= limits::kNumber) continue;  // also false for NaN
      throw InputError(place + ": point " + std::to_string(i) + " is not finite or lies beyond 1e18; repair the model");
    }
    low = glm::min(low, positions[i]);
    high = glm::max(high, positions[i]);
  }
  glm::dvec3 center(0.0);
  if (!positions.empty()) {
    const glm::dvec3 middle = 0.5 * (low + high), size = high - low;
    const glm::dvec3 away = glm::abs(middle);
    const double largest = std::max({size.x, size.y, size.z});
    if (largest > 0.0 && std::max({away.x, away.y, away.z}) > kFar * largest) center = middle;
  }
  result.positions.reserve(positions.size());
  for (const glm::dvec3& p : positions) result.positions.emplace_back(p - center);
  result.worldFromModel = glm::translate(glm::dmat4(1.0), center);
  return result;
}

}  // namespace boxprobe
