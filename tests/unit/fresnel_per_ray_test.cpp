// Fresnel's term belongs to each microfacet and not to the lobe's mean: of a non-metal the part of a lobe that leaves
// at a flat angle counts most. Judged by an integral in double precision (reflectedMean), with F0 of a non-metal.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>

#include "filters/math/technique/technique_table.h"
#include "filters/reference/study/study_tally.h"

namespace boxprobe {
namespace {

using study::RoomPoint;

constexpr float kNonMetal = 0.04f;

using Evaluate = glm::vec4 (*)(shading::ProbeMap, shading::ProbeShape, shading::ShadingPoint);

Evaluate evaluationOf(const char* id) {
  return evaluationRows()[static_cast<std::size_t>(parseTechnique(id).value().evaluation)].evaluate;
}

/// Values of 64 filtered rays.
std::vector<glm::dvec3> rays(const std::vector<RoomPoint>& points) {
  std::vector<glm::dvec3> values;
  for (RoomPoint p : points) {
    p.probe.parameters.samples = 64.0f;
    p.probe.parameters.filtered = 1;
    values.emplace_back(evaluationOf("raytraced")(p.chain, p.probe, p.point));
  }
  return values;
}

/// The same points with a reflectance that is the same from everywhere: Fresnel once for the whole lobe.
std::vector<RoomPoint> asReflectors(std::vector<RoomPoint> points) {
  for (RoomPoint& p : points) p.point.f0 = 1.0f;
  return points;
}

TEST(FresnelPerRay, OfNonMetalsInRoomsThatAreBoxes) {
  const study::RoomPoints rooms = study::randomPoints(517, 16, 40, 64, 2048, {}, kNonMetal);
  const std::vector<RoomPoint> plain = asReflectors(rooms.points);
  const auto error = [&](const std::vector<glm::dvec3>& values) {
    return study::tally(values, rooms.points).relativeRmse;
  };
  // Error with Fresnel per ray, and over that with Fresnel once for the lobe: at most.
  struct Promise {
    const char* id;
    double relative, overPlain;
  };
  for (const Promise& promise :
       {Promise{"footprint1", 0.30, 1.02}, Promise{"footprint2", 0.22, 0.98}, Promise{"footprint4", 0.16, 0.85},
        Promise{"footprint8", 0.12, 0.75}, Promise{"footprint16", 0.10, 0.65}}) {
    const double own = error(study::valuesOf(study::techniqueOf(promise.id), rooms.points));
    const double once = error(study::valuesOf(study::techniqueOf(promise.id), plain));
    std::printf("  %-12s relative error %.3f, with Fresnel once for the lobe %.3f\n", promise.id, own, once);
    EXPECT_LE(own, promise.relative) << promise.id;
    EXPECT_LE(own, promise.overPlain * once) << promise.id;
  }
  const double own = error(rays(rooms.points)), once = error(rays(plain));
  std::printf("  %-12s relative error %.3f, with Fresnel once for the lobe %.3f\n", "64 rays", own, once);
  EXPECT_LE(own, 0.05);
  EXPECT_LE(own, 0.45 * once);
}

TEST(FresnelPerRay, EvenLightStaysEven) {
  class Even : public shading::CubeSampler {
    glm::vec4 fetch(const glm::vec3&, float) const override { return {0.7f, 1.9f, 13.0f, 0.6f}; }
  };
  const Even even;
  const study::RoomPoints rooms = study::randomPoints(518, 1, 20, 16, 16);
  for (const char* id : {"footprint1", "footprint2", "footprint4", "footprint8", "footprint16", "raytraced"}) {
    for (const float samples : {1.0f, 3.0f, 16.0f}) {
      for (RoomPoint p : rooms.points) {
        for (const float f0 : {1.0e-3f, 0.04f, 0.71f, 1.0f, 3.0f}) {
          p.point.f0 = f0;
          p.probe.parameters.samples = samples;
          const glm::vec4 value = evaluationOf(id)(&even, p.probe, p.point);
          const glm::vec4 off = glm::abs(value / glm::vec4(0.7f, 1.9f, 13.0f, 0.6f) - 1.0f);
          ASSERT_LT(std::max({off.x, off.y, off.z, off.w}), 1.0e-4f)
              << id << ", " << samples << " samples, F0 " << f0 << ", roughness " << p.point.roughness;
        }
      }
    }
  }
}

// Averaged frames of three rays end at the integral: the norm of few rays is that of the surface, not of one that
// reflects all. Not filtered, as that blurs.
TEST(FresnelPerRay, FramesOfFewRaysAverageToTheIntegral) {
  const study::RoomPoints rooms = study::randomPoints(519, 2, 10, 32, 1 << 15, {}, kNonMetal);
  double sum = 0.0, truth = 0.0;
  constexpr int kFrames = 1024;
  for (RoomPoint p : rooms.points) {
    if (p.point.roughness > 0.5f) continue;
    p.probe.parameters.samples = 3.0f;
    p.probe.parameters.pattern = 2;
    for (p.point.frame = 0; p.point.frame < kFrames; ++p.point.frame) {
      sum += glm::dvec3(evaluationOf("raytraced")(p.chain, p.probe, p.point)).y / kFrames;
    }
    truth += p.truth.y;
  }
  std::printf("  mean light of frames of 3 rays over the integral's: %.4f\n", sum / truth);
  EXPECT_NEAR(sum / truth, 1.0, 0.01);
}

}  // namespace
}  // namespace boxprobe
