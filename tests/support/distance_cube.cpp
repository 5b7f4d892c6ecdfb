// See distance_cube.h.
#include "tests/support/distance_cube.h"

#include <glm/geometric.hpp>

#include "filters/math/shared/shared_math.h"

namespace boxprobe::test {

CubeMap distanceCube(const SurfaceRays& rays, const glm::dvec3& originWorld, const glm::dmat3& worldFromMap, int size) {
  CubeMap distance(size, 1);
  const auto centre = [size](int i) { return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(size) - 1.0f; };
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const glm::dvec3 along(glm::normalize(shading::cubeDirection(face, centre(column), centre(row))));
        const std::optional<SurfaceHit> hit = rays.first(originWorld, worldFromMap * along);
        distance.setTexel(0, face, column, row, glm::vec4(hit ? static_cast<float>(hit->distance) : 0.0f));
      }
    }
  }
  return distance;
}

}  // namespace boxprobe::test
