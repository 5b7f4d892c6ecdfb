// The lattice of diffuse light: its nodes, its coefficients against those of the whole capture and against walls whose
// light is known, its axes.
#include "filters/math/cube/diffuse_lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <random>

#include "filters/math/cube/spherical_harmonics.h"
#include "filters/math/technique/technique_table.h"
#include "tests/support/lamp_truth.h"

namespace {

using namespace boxprobe;
using glm::ivec3;
using glm::mat3;
using glm::vec3;
using glm::vec4;

const vec3 kLow(-1.7f, -0.9f, -2.6f), kHigh(2.9f, 1.6f, 1.2f);  // of the room, its capture origin not in its middle

CubeMap captureOf(int faceSize, const std::function<vec3(const vec3&)>& radiance) {
  CubeMap map(faceSize, 1);
  const auto at = [&](int i) { return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(faceSize) - 1.0f; };
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < faceSize; ++row) {
      for (int column = 0; column < faceSize; ++column) {
        map.setTexel(0, face, column, row, vec4(radiance(shading::cubeDirection(face, at(column), at(row))), 1.0f));
      }
    }
  }
  return map;
}

shading::ProbeShape shapeOf(const char* technique = "box") {
  shading::ProbeShape shape{};
  shape.boxMin = kLow;
  shape.boxMax = kHigh;
  shape.projection = parseTechnique(technique).value().projection;
  shape.parameters = standardParameters();
  return shape;
}

vec3 someLight(const vec3& d) {
  const vec3 n = glm::normalize(d);
  return vec3(0.7f + 0.5f * n.x, 0.3f + 0.2f * n.y * n.z, 0.9f - 0.6f * n.z + 0.2f * n.x * n.y);
}

vec3 randomDirection(std::mt19937& random) {
  std::normal_distribution<float> gauss;
  return glm::normalize(vec3(gauss(random), gauss(random), gauss(random)));
}

TEST(DiffuseLattice, HasANodeAMetreFromWallToWall) {
  EXPECT_EQ(latticeNodes({4.6f, 2.5f, 3.8f}, 1.0f), ivec3(6, 4, 5));  // 2.5 counts as 3
  EXPECT_EQ(latticeNodes({4.6f, 2.4f, 3.8f}, 2.0f), ivec3(3, 2, 3));
  EXPECT_EQ(latticeNodes({0.05f, 700.0f, 3.0e38f}, 1.0f), ivec3(2, 16, 16));
  EXPECT_EQ(latticeNodes({0.0f, -3.0f, std::nanf("")}, 1.0f), ivec3(2));
  EXPECT_EQ(latticeNodes({4.6f, 2.4f, 3.8f}, 0.0f), ivec3(2));
  EXPECT_EQ(latticeNodes({4.6f, 2.4f, 3.8f}, std::numeric_limits<float>::infinity()), ivec3(2));
  const DiffuseLattice lattice = makeDiffuseLattice(plainMeans(captureOf(4, someLight)), shapeOf());
  EXPECT_EQ(lattice.nodes, ivec3(6, 4, 5));
  EXPECT_EQ(lattice.texels.size(), 7u * 6 * 4 * 5);
  EXPECT_NEAR(glm::length(lattice.low - (kLow + 0.15f)), 0.0f, 1e-6f);
  EXPECT_NEAR(glm::length(lattice.high - (kHigh - 0.15f)), 0.0f, 1e-6f);
  shading::ProbeShape thin = shapeOf();
  thin.boxMax.y = thin.boxMin.y + 0.2f;  // no room for the inset
  const DiffuseLattice flat = makeDiffuseLattice(plainMeans(captureOf(4, someLight)), thin);
  EXPECT_NEAR(flat.low.y, thin.boxMin.y + 0.05f, 1e-6f);
  EXPECT_NEAR(flat.high.y, thin.boxMin.y + 0.15f, 1e-6f);
}

// A room in millimetres: its nodes stand as far from its walls as there is room for unevenness.
TEST(DiffuseLattice, LengthsAreOfTheBox) {
  EXPECT_EQ(metreOf({4.6f, 2.5f, 3.8f}), 1.0);
  EXPECT_EQ(metreOf({10.0f, 90.0f, 38.0f}), 1.0);
  EXPECT_NEAR(metreOf({400.0f, 80.0f, 51.0f}), 5.1, 1e-6);
  EXPECT_NEAR(metreOf({5400.0f, 2130.0f, 5100.0f}), 852.0, 1e-9);
  EXPECT_EQ(metreOf({std::nanf(""), std::nanf(""), std::nanf("")}), 1.0);
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ(metreOf({infinite, infinite, infinite}), 1.0);
  EXPECT_EQ(metreOf({-5.0f, 20.0f, 30.0f}), 1.0);
  CubeMap means(4, 1);
  for (int face = 0; face < 6; ++face) std::fill_n(means.face(0, face), 4 * 4 * 4, 1.0f);
  shading::ProbeShape probe{};
  probe.boxMin = {-2400.0f, -1130.0f, -3100.0f};
  probe.boxMax = {3000.0f, 1000.0f, 2000.0f};
  const DiffuseLattice lattice = makeDiffuseLattice(plainMeans(means), probe);
  EXPECT_EQ(lattice.nodes, ivec3(7, 4, 7));  // of 5400, 2130 and 5100, one each 852
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(lattice.inset[axis], 0.15f * 852.0f, 1e-3f);
    EXPECT_NEAR(lattice.low[axis], probe.boxMin[axis] + 0.15f * 852.0f, 1e-2f);
    EXPECT_NEAR(lattice.high[axis], probe.boxMax[axis] - 0.15f * 852.0f, 1e-2f);
  }
}

TEST(DiffuseLattice, MeansKeepTheLight) {
  const CubeMap means = plainMeans(captureOf(32, someLight));
  ASSERT_EQ(means.levels(), 6);
  glm::dvec3 first(0.0);
  for (int level = 0; level < 6; ++level) {
    const int size = means.levelSize(level);
    glm::dvec3 sum(0.0);
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
          const double s = -1.0 + 2.0 * column / size, t = -1.0 + 2.0 * row / size, step = 2.0 / size;
          sum += cubeSolidAngle(s, t, s + step, t + step) * glm::dvec3(means.texel(level, face, column, row));
        }
      }
    }
    if (level == 0) first = sum;
    EXPECT_NEAR(glm::length(sum - first), 0.0, 1.0e-5) << level;
  }
}

// Where rays are not bent towards a box, every node sees what the origin sees.
TEST(DiffuseLattice, OfTheFarAwayHasTheCapturesOwnCoefficients) {
  const int size = 16;
  const CubeMap capture = captureOf(size, someLight);
  std::array<std::vector<float>, 6> faces;
  for (int face = 0; face < 6; ++face) {
    const float* texels = capture.face(0, face);
    faces[static_cast<std::size_t>(face)].assign(texels, texels + 4 * size * size);
  }
  const ShCoefficients c = irradianceCoefficients(faces, size);
  const DiffuseLattice lattice = makeDiffuseLattice(plainMeans(capture), shapeOf("infinite"));
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    const vec3 n = randomDirection(random), p = 3.0f * randomDirection(random);
    const vec3 found = shading::latticeIrradiance(lattice.shape(), p, n, n);
    const vec3 whole = shading::shIrradiance(n, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]);
    EXPECT_NEAR(glm::length(found - whole), 0.0f, 0.003f) << i;
  }
}

TEST(DiffuseLattice, IsLinearBetweenNodesAndConstantBeyond) {
  const DiffuseLattice lattice = makeDiffuseLattice(plainMeans(captureOf(16, someLight)), shapeOf());
  const shading::LatticeShape shape = lattice.shape();
  const vec3 step = (lattice.high - lattice.low) / vec3(lattice.nodes - 1);
  const auto light = [&](const vec3& p) {
    return shading::latticeIrradiance(shape, p, vec3(0, 1, 0), glm::normalize(vec3(0.4f, -0.7f, 0.5f)));
  };
  const vec3 a = lattice.low + step * vec3(2.0f, 1.0f, 3.0f);
  for (int axis = 0; axis < 3; ++axis) {
    vec3 way(0.0f);
    way[axis] = step[axis];
    const vec3 between = light(a + 0.3f * way), mixed = 0.7f * light(a) + 0.3f * light(a + way);
    EXPECT_NEAR(glm::length(between - mixed), 0.0f, 1e-5f) << axis;
    EXPECT_GT(glm::length(light(a + way) - light(a)), 1e-3f) << axis;  // it does change
  }
  EXPECT_EQ(light(vec3(100.0f, 0.1f, 0.2f)), light(vec3(lattice.high.x, 0.1f, 0.2f)));
  EXPECT_EQ(light(vec3(-0.3f, -9.0f, 0.2f)), light(vec3(-0.3f, lattice.low.y, 0.2f)));
  // Place by place the texels: node (2, 1, 3) of the second part.
  const std::size_t at = 1 * 6 * 4 * 5 + (3 * 4 + 1) * 6 + 2;
  EXPECT_EQ(lattice.fetchLattice(vec3(2.0f, 1.0f, 3.0f), 1), lattice.texels[at]);
}

// The wall at -x shines, the others are dark: what quadrature over it says, well inside the room.
TEST(DiffuseLattice, AWallShinesAsItsPolygonDoes) {
  const DiffuseLattice lattice = makeDiffuseLattice(
      plainMeans(captureOf(64,
                           [](const vec3& d) {
                             const vec3 factors = shading::slabFactors(vec3(0.0f), d, kLow, kHigh);
                             const bool wall = d.x < 0.0f && factors.x <= factors.y && factors.x <= factors.z;
                             return wall ? vec3(1.0f, 0.5f, 0.25f) : vec3(0.0f);
                           })),
      shapeOf());
  for (const vec3& p : {vec3(0.0f), vec3(1.6f, 0.8f, -1.9f), vec3(0.7f, -0.6f, 0.5f), vec3(2.4f, 1.2f, -0.4f)}) {
    for (const vec3& n :
         {vec3(-1, 0, 0), glm::normalize(vec3(-1, 0.5f, 0.3f)), glm::normalize(vec3(-0.3f, 0.2f, -1))}) {
      std::vector<test::LongVec> wall;
      for (const auto& [y, z] : {std::pair{kLow.y, kLow.z}, {kHigh.y, kLow.z}, {kHigh.y, kHigh.z}, {kLow.y, kHigh.z}}) {
        wall.emplace_back(vec3(kLow.x, y, z) - p);
      }
      const auto truth = static_cast<float>(test::trueFormFactor(wall, test::LongVec(n)));
      const vec3 found = shading::latticeIrradiance(lattice.shape(), p, n, n);
      EXPECT_NEAR(found.x, truth, 0.03f) << p.x << " " << n.x;
      EXPECT_NEAR(found.y, 0.5f * found.x, 1e-5f);
      EXPECT_NEAR(found.z, 0.25f * found.x, 1e-5f);
    }
  }
}

// The box turned in the world, and its map along other axes than its own: the same light on a surface turned with it.
TEST(DiffuseLattice, KeepsItsAxesApart) {
  const auto turn = [](float a, float b) {
    const mat3 x(vec3(1, 0, 0), vec3(0, std::cos(a), std::sin(a)), vec3(0, -std::sin(a), std::cos(a)));
    const mat3 y(vec3(std::cos(b), 0, -std::sin(b)), vec3(0, 1, 0), vec3(std::sin(b), 0, std::cos(b)));
    return y * x;
  };
  const mat3 mapFromProbe = turn(0.4f, -1.1f), worldFromProbe = turn(-0.7f, 2.3f);
  const DiffuseLattice upright = makeDiffuseLattice(plainMeans(captureOf(64, someLight)), shapeOf());
  const DiffuseLattice turned = makeDiffuseLattice(
      plainMeans(captureOf(64, [&](const vec3& d) { return someLight(glm::transpose(mapFromProbe) * d); })), shapeOf(),
      mapFromProbe, worldFromProbe);
  std::mt19937 random(9);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  for (int i = 0; i < 100; ++i) {
    const vec3 n = randomDirection(random), p = kLow + (kHigh - kLow) * vec3(unit(random), unit(random), unit(random));
    const vec3 a = shading::latticeIrradiance(upright.shape(), p, n, n);
    const vec3 b = shading::latticeIrradiance(turned.shape(), p, n, worldFromProbe * n);
    EXPECT_NEAR(glm::length(a - b), 0.0f, 0.004f) << i;
  }
}

TEST(DiffuseLattice, OfNothingIsDark) {
  const DiffuseLattice none = makeDiffuseLattice(CubeMap(), shapeOf());
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.fetchLattice(vec3(0.0f), 3), vec4(0.0f));
  EXPECT_EQ(shading::latticeIrradiance(none.shape(), vec3(0.3f), vec3(0, 1, 0), vec3(0, 1, 0)), vec3(0.0f));
}

}  // namespace
