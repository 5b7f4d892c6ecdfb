// Normals where thousands of triangles meet: right, and in linear time.
#include "filters/vtk/import/smooth_normals.h"

#include <gtest/gtest.h>
#include <time.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {
namespace {

/// A cone of so many triangles around its tip; the angle between axis and normals is that of `height` to 1.
Mesh cone(int triangles, float height) {
  Mesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const auto rim = [&](int k) {
      const double angle = 2.0 * 3.14159265358979 * k / triangles;
      return glm::vec3(std::cos(angle), std::sin(angle), 0.0);
    };
    for (const glm::vec3& p : {glm::vec3(0, 0, height), rim(i), rim(i + 1)}) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(p);
    }
  }
  return mesh;
}

TEST(SmoothNormals, AFanOfThousandsIsAsSmoothAsOneOfFew) {
  for (const int triangles : {48, 65, 1000, 20000}) {
    Mesh flat = cone(triangles, 0.2f);  // all within 23 degrees of each other
    computeNormals(flat);
    ASSERT_EQ(flat.normals.size(), 3u * static_cast<std::size_t>(triangles));
    for (std::size_t i = 0; i < flat.normals.size(); i += 3) {
      ASSERT_GT(glm::dot(flat.normals[i], glm::vec3(0, 0, 1)), 0.999f) << triangles << " " << i;
    }
    Mesh steep = cone(triangles, 5.0f);  // opposite sides face away from each other
    computeNormals(steep);
    for (std::size_t i = 0; i < steep.normals.size(); i += 3) {
      const glm::vec3 own = glm::normalize(
          glm::cross(steep.positions[i + 1] - steep.positions[i], steep.positions[i + 2] - steep.positions[i]));
      ASSERT_GT(glm::dot(steep.normals[i], own), 0.98f) << triangles << " " << i;
    }
  }
}

/// Of a processor, for this thread: other threads and other programs do not count.
double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

TEST(SmoothNormals, TheTimeIsLinear) {
  const auto seconds = [](int triangles) {
    Mesh mesh = cone(triangles, 1.0f);
    const double begun = threadSeconds();
    computeNormals(mesh);
    return threadSeconds() - begun;
  };
  seconds(1000);
  // Quadratic: 100 times as long. The bound is wide for a machine whose caches others use as well.
  EXPECT_LT(seconds(200000), 40.0 * seconds(20000) + 0.5);
}

}  // namespace
}  // namespace boxprobe
