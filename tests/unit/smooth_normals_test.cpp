// Normals where thousands of triangles meet: right, and in linear time.
#include "filters/io/mesh/smooth_normals.h"

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

// All meet in the tip. Pairs of them would be 40,000 million: the test would be ended before that is done.
TEST(SmoothNormals, ManyTrianglesMayMeetInOnePoint) {
  constexpr int kTriangles = 200000;
  Mesh mesh = cone(kTriangles, 1.0f);
  computeNormals(mesh);
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0f, 1e-4f);
}

}  // namespace
}  // namespace boxprobe
