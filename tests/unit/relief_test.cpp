// The levels of a probe's distances, and rays followed through them, in a room with a pillar whose every hit is known.
#include "filters/math/cube/relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <random>

#include "filters/math/technique/technique_table.h"

namespace {

using namespace boxprobe;
using glm::vec3;

const vec3 kLow(-3.0f, -1.2f, -2.0f), kHigh(2.5f, 1.6f, 2.8f);            // the room, its origin the probe's
const vec3 kPillarLow(0.9f, -1.2f, 0.5f), kPillarHigh(1.5f, 1.6f, 1.1f);  // from floor to ceiling
constexpr float kNothing = 1.0e30f;

float intoPillar(const vec3& from, const vec3& along) {
  float enter = 0.0f, leave = kNothing;
  for (int axis = 0; axis < 3; ++axis) {
    const float a = (kPillarLow[axis] - from[axis]) / along[axis], b = (kPillarHigh[axis] - from[axis]) / along[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter > 0.0f && enter < leave ? enter : kNothing;
}

float trueHit(const vec3& from, const vec3& along) {
  const vec3 walls = shading::slabFactors(from, along, kLow, kHigh);
  return std::min({walls.x, walls.y, walls.z, intoPillar(from, along)});
}

CubeMap distances(int size) {
  CubeMap map(size, 1);
  const auto at = [size](int i) { return (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(size) - 1.0f; };
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        const vec3 along = glm::normalize(shading::cubeDirection(face, at(column), at(row)));
        map.setTexel(0, face, column, row, glm::vec4(trueHit(vec3(0.0f), along), 0.0f, 0.0f, 0.0f));
      }
    }
  }
  return map;
}

// Of every texel, at its four corners, what each level says about the block around it.
TEST(Relief, LevelsBoundWhatTheirTexelsShow) {
  const Relief relief(distances(64));
  const CubeMap& bounds = relief.bounds();
  ASSERT_EQ(bounds.faceSize(), 32);
  ASSERT_EQ(bounds.levels(), 6);
  std::size_t outside = 0, flat = 0, blocks = 0;
  for (int level = 0; level < bounds.levels(); ++level) {
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < 64; ++row) {
        for (int column = 0; column < 64; ++column) {
          const glm::vec4 bound = bounds.texel(level, face, column >> (level + 1), row >> (level + 1));
          const vec3 plane(relief.texels().texel(0, face, column, row));
          for (int corner = 0; corner < 4; ++corner) {
            const vec3 at =
                shading::cubeDirection(face, 2.0f * static_cast<float>(column + (corner & 1)) / 64.0f - 1.0f,
                                       2.0f * static_cast<float>(row + (corner >> 1)) / 64.0f - 1.0f);
            const float seen = glm::dot(plane, at), most = glm::dot(vec3(bound), at);
            outside += seen <= most + 1.0e-5f && seen >= most - bound.w - 1.0e-5f ? 0 : 1;
          }
          if (level == 2) {
            ++blocks;
            flat += bound.w < 1.0e-4f ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_EQ(outside, 0u);
  std::printf("  %.2f of the blocks of 8 x 8 texels are one plane\n",
              static_cast<double>(flat) / static_cast<double>(blocks));
  EXPECT_GT(flat, blocks / 2) << "walls are planes, however steeply they are seen";
}

// The share of rays off the floor whose hit is off the true one by over 2 cm, of those that end on something the origin
// sees.
double missed(const Relief& relief, const ReliefBlocks& blocks, float steps, double* lookups) {
  class Counted : public shading::ReliefSampler {
   public:
    explicit Counted(const Relief& relief) : relief_(relief) {}
    glm::vec4 fetchRelief(const vec3& direction, float level) const override {
      ++count;
      return relief_.fetchRelief(direction, level);
    }
    float reliefSize() const override { return relief_.reliefSize(); }
    mutable int count = 0;

   private:
    const Relief& relief_;
  };
  shading::ProbeShape probe{};
  probe.boxMin = kLow;
  probe.boxMax = kHigh;
  probe.maxLevel = 6.0f;
  probe.projection = parseTechnique("impostor")->projection;
  probe.parameters = standardParameters();
  probe.parameters.steps = steps;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::size_t off = 0, all = 0;
  *lookups = 0.0;
  while (all < 20000) {
    const vec3 from(kLow.x + unit(random) * (kHigh.x - kLow.x), kLow.y, kLow.z + unit(random) * (kHigh.z - kLow.z));
    const vec3 along = glm::normalize(vec3(unit(random) - 0.5f, 0.05f + 0.6f * unit(random), unit(random) - 0.5f));
    const bool underPillar =
        from.x > kPillarLow.x && from.x < kPillarHigh.x && from.z > kPillarLow.z && from.z < kPillarHigh.z;
    const vec3 end = from + trueHit(from, along) * along;
    if (underPillar || trueHit(vec3(0.0f), glm::normalize(end)) < 0.98f * glm::length(end)) continue;
    const Counted counted(relief);
    shading::ProbeData data;
    data.relief = &counted;
    data.blocks = &blocks;
    probe.slot = &data;
    const shading::ProbeHit hit = shading::projectRay(probe, from, vec3(0.0f, 1.0f, 0.0f), along);
    EXPECT_LE(static_cast<float>(counted.count), steps);
    *lookups += counted.count;
    ++all;
    // Seen from the origin: what is looked up.
    off += glm::length(glm::normalize(hit.direction) - glm::normalize(end)) < 0.02f / glm::length(end) ? 0 : 1;
  }
  *lookups /= static_cast<double>(all);
  return static_cast<double>(off) / static_cast<double>(all);
}

TEST(Relief, AFollowedRayFindsWhatTheProbeSaw) {
  const Relief relief(distances(256));
  const ReliefBlocks blocks = reliefBlocks(relief, kLow, kHigh, glm::mat3(1.0f));
  for (const float steps : {3.0f, 8.0f, 16.0f, 64.0f}) {
    double lookups = 0.0;
    const double share = missed(relief, blocks, steps, &lookups);
    std::printf("  %2.0f steps: %.2f %% of the rays are off, %.2f lookups\n", static_cast<double>(steps), 100.0 * share,
                lookups);
    if (steps > 10.0f) {
      EXPECT_LE(share, 0.01);
    }
  }
}

// Looking twice in one step is no way past the limit: missed() counts for every ray.
TEST(Relief, NoRayTakesMoreStepsThanAsked) {
  const Relief relief(distances(64));
  const ReliefBlocks blocks = reliefBlocks(relief, kLow, kHigh, glm::mat3(1.0f));
  for (float steps = 1.0f; steps < 14.0f; ++steps) {
    double lookups = 0.0;
    missed(relief, blocks, steps, &lookups);
    EXPECT_GT(lookups, 0.5) << steps;
  }
}

// A flat box has no interior, and squares of a float end at 1e38.
TEST(Relief, BoxesWithoutUseHaveNoBlocks) {
  const Relief relief(distances(64));
  const auto count = [&relief](const glm::vec3& low, const glm::vec3& high) {
    return reliefBlocks(relief, low, high, glm::mat3(1.0f)).count;
  };
  ASSERT_GT(count(kLow, kHigh), 0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 flat = kHigh;
    flat[axis] = kLow[axis];
    EXPECT_EQ(count(kLow, flat), 0) << axis;
    flat[axis] += 0.5e-6f * (kHigh - kLow)[axis == 0 ? 1 : 0];
    EXPECT_EQ(count(kLow, flat), 0) << axis;
  }
  for (const float scale : {1.0e16f, 1.0e-17f}) EXPECT_EQ(count(scale * kLow, scale * kHigh), 0) << scale;
}

// What an octahedron's two coordinates of 12 bits lose of a direction, wherever it points. A cell reaches 1/4096 to
// each side in both; along the octahedron that is at most the root of 6 as far, seen from its middle, at least the root
// of 1/3 away.
TEST(Relief, FarDirectionsComeBack) {
  const double allowed = std::sqrt(6.0) / 4096.0 * std::sqrt(3.0);
  std::mt19937 random(23);
  std::normal_distribution<float> component;
  double worst = 0.0;
  for (int i = 0; i < 30000; ++i) {
    // Every third lies near a plane between octants, where the lower half's fold changes its sign.
    vec3 along(component(random), component(random), component(random));
    if (i % 3 == 0) along[i / 3 % 3] *= 0.03f;
    along = glm::normalize(along);
    const vec3 back = glm::normalize(shading::reliefDirection(Relief::farCode(along)));
    const double angle = std::asin(std::min(1.0, double(glm::length(glm::cross(along, back)))));
    worst = std::max(worst, angle);
    ASSERT_GT(glm::dot(along, back), 0.0f) << along.x << " " << along.y << " " << along.z;
    ASSERT_LE(angle, allowed) << along.x << " " << along.y << " " << along.z;
  }
  EXPECT_GT(worst, 0.3 * allowed) << "so few bits lose something";
}

// Faces of few texels, and a map that saw nothing.
TEST(Relief, SmallAndEmptyMaps) {
  for (const int size : {1, 2, 4}) {
    for (const bool empty : {false, true}) {
      const Relief relief(empty ? CubeMap(size, 1) : distances(size));
      double lookups = 0.0;
      missed(relief, {}, 64.0f, &lookups);
      EXPECT_GT(lookups, 0.0);
      EXPECT_LE(lookups, 64.0);
    }
  }
}

}  // namespace
