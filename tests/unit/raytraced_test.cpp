// The ray-traced evaluation: its patterns, the mask that shifts them, and how near its filters and its two ways of
// sampling come to the integral.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <map>

#include "filters/math/cube/light_table.h"
#include "filters/math/sampling/blue_noise.h"
#include "filters/math/sampling/void_and_cluster.h"
#include "filters/math/technique/technique_table.h"
#include "filters/reference/study/study_tally.h"

namespace boxprobe {
namespace {

enum Pattern { kWhite, kBlue, kR2, kDeterministic };

const EvaluationRow& raytraced() {
  return evaluationRows()[static_cast<std::size_t>(parseTechnique("raytraced")->evaluation)];
}

// Share of a mask's variation in waves longer than `longest`th of its side.
double lowFrequencyShare(const std::vector<std::uint16_t>& mask, int size, int longest) {
  double low = 0.0, all = 0.0;
  const double mean = 0.5 * (static_cast<double>(mask.size()) - 1.0), turn = 6.283185307179586 / size;
  for (const std::uint16_t value : mask) all += (value - mean) * (value - mean);
  for (int v = -longest; v <= longest; ++v) {
    for (int u = -longest; u <= longest; ++u) {
      if (u * u + v * v > longest * longest) continue;
      std::complex<double> sum = 0.0;
      for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
          sum += (mask[static_cast<std::size_t>(y * size + x)] - mean) * std::polar(1.0, turn * (u * x + v * y));
        }
      }
      low += std::norm(sum) / static_cast<double>(mask.size());
    }
  }
  return low / all;
}

TEST(BlueNoise, HoldsNoLongWaves) {
  const std::vector<std::uint16_t> mask = voidAndCluster(kBlueNoiseSize, 1);
  std::vector<std::uint16_t> sorted = mask;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], i) << "each rank once";
  EXPECT_EQ(mask, voidAndCluster(kBlueNoiseSize, 1));
  std::vector<std::uint16_t> white = mask;
  std::shuffle(white.begin(), white.end(), std::mt19937(1));
  const double blue = lowFrequencyShare(mask, kBlueNoiseSize, 10),
               chance = lowFrequencyShare(white, kBlueNoiseSize, 10);
  std::printf("  share of the variation in waves longer than 6.4 pixels: blue %.5f, white %.4f\n", blue, chance);
  EXPECT_LT(blue, 0.01 * chance);
  // Of 8 successive frames, which shift it by the sequence, as well: the wrap from 1 to 0 costs a little.
  for (int frame = 1; frame <= 8; ++frame) {
    std::vector<std::uint16_t> shifted = mask;
    const auto by = static_cast<unsigned>(frame * 0.5698402909980532 * 4096);
    for (std::uint16_t& value : shifted) value = static_cast<std::uint16_t>((value + by) % 4096);
    EXPECT_LT(lowFrequencyShare(shifted, kBlueNoiseSize, 10), 0.2 * chance) << frame;
  }
}

// Largest distance between the share of points in a corner rectangle and its area.
double discrepancy(const std::vector<glm::vec2>& points) {
  double worst = 0.0;
  for (int i = 1; i <= 32; ++i) {
    for (int k = 1; k <= 32; ++k) {
      const float x = static_cast<float>(i) / 32.0f, y = static_cast<float>(k) / 32.0f;
      const auto inside = std::count_if(points.begin(), points.end(), [=](auto p) { return p.x < x && p.y < y; });
      worst = std::max(worst, std::abs(static_cast<double>(inside) / static_cast<double>(points.size()) -
                                       static_cast<double>(x) * static_cast<double>(y)));
    }
  }
  return worst;
}

TEST(SamplePatterns, AreEvenButWhite) {
  const auto mean = [](int pattern, int samples, int frames) {
    double sum = 0.0;
    for (int pixel = 0; pixel < 16; ++pixel) {
      std::vector<glm::vec2> points;
      shading::ShadingPoint at{};
      at.f0 = 1.0f;
      at.pixel = {pixel, 3 * pixel};
      for (at.frame = 0; at.frame < frames; ++at.frame) {
        const shading::SamplePattern drawn = shading::samplePattern(at, pattern, samples);
        for (int i = 0; i < samples; ++i) points.push_back(shading::samplePoint(drawn, i));
      }
      for (const glm::vec2& p : points) {
        EXPECT_TRUE(p.x >= 0.0f && p.x < 1.0f && p.y >= 0.0f && p.y < 1.0f) << p.x << " " << p.y;
      }
      sum += discrepancy(points) / 16.0;
    }
    return sum;
  };
  const double white = mean(kWhite, 64, 1);
  for (const int pattern : {kBlue, kR2, kDeterministic}) {
    const double even = mean(pattern, 64, 1), overFrames = mean(pattern, 1, 64);
    std::printf("  pattern %d: discrepancy of 64 points %.3f, of 64 frames of one %.3f; white %.3f\n", pattern, even,
                overFrames, white);
    EXPECT_LT(even, 0.6 * white) << pattern;
    EXPECT_LT(overFrames, 0.6 * white) << pattern;
  }
}

class InRooms : public testing::Test {
 protected:
  // Made once for all tests.
  static void SetUpTestSuite() {
    rooms_ = new study::RoomPoints(study::randomPoints(410, 8, 20, 64, 4096));
    lights_ = new std::map<const study::PaddedCube*, LightTable>;
    data_ = new std::map<const study::PaddedCube*, shading::ProbeData>;
    for (const auto& chain : rooms_->chains) {
      (*lights_)[chain.get()] = makeLightTable(captureOf(*chain));
      (*data_)[chain.get()].light = &lights_->at(chain.get());
    }
    int count = 0;
    for (study::RoomPoint& p : rooms_->points) {
      p.probe.slot = &data_->at(p.chain);
      p.point.pixel = {count % 64, count / 64};
      ++count;
    }
  }
  static void TearDownTestSuite() {
    delete rooms_;
    delete lights_;
    delete data_;
  }

  static CubeMap captureOf(const study::PaddedCube& chain) {
    constexpr int kSize = 64;
    CubeMap capture(kSize, 1);
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < kSize; ++row) {
        for (int column = 0; column < kSize; ++column) {
          const float s = (2.0f * static_cast<float>(column) + 1.0f) / kSize - 1.0f;
          const float t = (2.0f * static_cast<float>(row) + 1.0f) / kSize - 1.0f;
          capture.setTexel(0, face, column, row, chain.fetch(shading::cubeDirection(face, s, t), 0.0f));
        }
      }
    }
    return capture;
  }

  // The mean of `frames` frames against the integral.
  template <typename Set>
  study::TechniqueTally judge(int frames, const Set& set) const {
    shading::TechniqueParameters parameters = standardParameters();
    set(parameters);
    const auto mean = [&](study::RoomPoint p) {
      p.probe.parameters = parameters;
      glm::dvec3 sum(0.0);
      for (p.point.frame = 0; p.point.frame < frames; ++p.point.frame) {
        sum += glm::dvec3(raytraced().evaluate(p.chain, p.probe, p.point));
      }
      return sum / static_cast<double>(frames);
    };
    return study::tally(study::valuesOf(mean, rooms_->points), rooms_->points);
  }

  static study::RoomPoints* rooms_;
  static std::map<const study::PaddedCube*, LightTable>* lights_;
  static std::map<const study::PaddedCube*, shading::ProbeData>* data_;
};
study::RoomPoints* InRooms::rooms_ = nullptr;
std::map<const study::PaddedCube*, LightTable>* InRooms::lights_ = nullptr;
std::map<const study::PaddedCube*, shading::ProbeData>* InRooms::data_ = nullptr;

TEST_F(InRooms, FramesAverageToTheIntegral) {
  for (const int samples : {1, 16}) {
    for (const int sampling : {0, 1}) {
      const study::TechniqueTally many = judge(2560 / samples, [=](auto& p) {
        p.samples = static_cast<float>(samples);
        p.sampling = sampling;
      });
      std::printf("  %d samples, sampling %d: error %.4f, light off by at most %.4f\n", samples, sampling, many.rmse,
                  many.worstLight());
      EXPECT_LT(many.rmse, 0.015) << samples << " " << sampling;
      EXPECT_LT(many.worstLight(), 0.08) << samples << " " << sampling;
    }
  }
}

TEST_F(InRooms, FiltersAndBrightnessEachBuyError) {
  const auto error = [this](int samples, auto set) {
    return judge(1,
                 [&](auto& p) {
                   p.samples = static_cast<float>(samples);
                   set(p);
                 })
        .rmse;
  };
  const double hdrp = study::tally(study::valuesOf(study::techniqueOf("hdrp"), rooms_->points), rooms_->points).rmse;
  for (const int samples : {16, 64}) {
    const double white = error(samples, [](auto& p) { p.pattern = kWhite; });
    const double plain = error(samples, [](auto& p) { p.pattern = kBlue; });
    const double offset = error(samples, [](auto& p) { p.levelOffset = 1; });
    const double filtered = error(samples, [](auto& p) { p.filtered = 1; });
    const double brightness = error(samples, [](auto& p) { p.sampling = 1; });
    std::printf("  %d samples: white %.4f, plain %.4f, level offset %.4f, filtered %.4f, brightness %.4f\n", samples,
                white, plain, offset, filtered, brightness);
    EXPECT_LT(plain, white);
    if (samples == 64) {
      std::printf("  over hdrp: plain %.3f, level offset %.3f, filtered %.3f\n", plain / hdrp, offset / hdrp,
                  filtered / hdrp);
      EXPECT_LE(filtered, 0.20 * hdrp);
      EXPECT_LT(plain, hdrp);
    }
    EXPECT_LT(offset, 0.7 * plain);
    EXPECT_LT(filtered, 0.7 * offset);
    EXPECT_LT(brightness, 0.6 * plain);
  }
}

// Counts fetches; every texel is the same.
struct EvenMap : shading::CubeSampler {
  glm::vec4 fetch(const glm::vec3& direction, float level) const override {
    ++fetches;
    const bool finite = std::isfinite(direction.x + direction.y + direction.z + level);
    return finite ? glm::vec4(3.0f) : glm::vec4(NAN);
  }
  mutable int fetches = 0;
};

TEST_F(InRooms, EvenLightStaysEvenAndAMirrorPaysForOneRay) {
  const glm::vec3 directions[] = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}, {0.6f, 0.8f, 0}, {1, 1.0e-7f, 0}};
  for (const float roughness : {0.0f, 1.0e-3f, 0.02f, 0.5f, 1.0f}) {
    for (const int samples : {1, 5, 64}) {
      for (const int choice : {0, 1, 2, 3}) {
        for (const glm::vec3& view : directions) {
          for (const float height : {-1.0f, 0.0f, 3.0f, 5.0f}) {  // on the wall, inside, on the ceiling, outside
            study::RoomPoint c = rooms_->points.back();
            c.point.position = {0.1f, height, 0.0f};
            c.point.normal = {0, 1, 0};
            c.point.view = view;
            c.point.reflection = glm::reflect(-view, c.point.normal);
            c.point.roughness = roughness;
            c.probe.parameters = standardParameters();
            c.probe.parameters.samples = static_cast<float>(samples);
            c.probe.parameters.filtered = choice == 1;
            c.probe.parameters.levelOffset = choice == 2;
            c.probe.parameters.sampling = choice == 3 && samples >= 5 ? 1 : 0;
            const EvenMap map;
            const glm::vec4 value = raytraced().evaluate(&map, c.probe, c.point);
            const bool few = c.probe.parameters.sampling == 1 && samples < 8;  // noise, then
            EXPECT_NEAR(value.x, 3.0f, few ? 9.0f : 1.0e-4f)
                << roughness << " " << samples << " " << choice << " " << height;
            EXPECT_LE(map.fetches, samples + 1);
            if (roughness == 0.0f) {
              EXPECT_EQ(map.fetches, 1);
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace boxprobe
