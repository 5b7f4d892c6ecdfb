// The prefilter on the CPU against a reference without sampling: nothing gained, nothing lost, no seam, no sparkle, and
// the frosty filter as wide as its law.
#include <gtest/gtest.h>

#include "filters/math/cube/cube_filter.h"
#include "filters/math/cube/cube_filter_reference.h"
#include "filters/math/cube/openings.h"
#include "tests/unit/filter_cubes.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

PrefilterSettings frosty() {
  PrefilterSettings settings;
  settings.filter = FilterLobe::Kind::Gaussian;
  return settings;
}

CubeMap referenceChain(const CubeMap& source, const PrefilterSettings& settings) {
  CubeMap chain(source.faceSize(), prefilterLevels(source.faceSize()));
  const CubeFilterReference reference(source);
  for (int level = 1; level < chain.levels(); ++level) {
    reference.filterLevel(lobeOfLevel(settings, level, chain.levels() - 1), chain, level);
  }
  return chain;
}

double errorOfLevel(const CubeMap& a, const CubeMap& reference, int level) {
  double difference = 0.0, size = 0.0;
  forEachTexel(reference.levelSize(level), [&](int face, int column, int row) {
    const glm::vec4 r = reference.texel(level, face, column, row), d = a.texel(level, face, column, row) - r;
    difference += glm::dot(d, d);
    size += glm::dot(r, r);
  });
  return std::sqrt(difference / size);
}

TEST(Prefilter, AConstantStaysConstantAtEveryLevel) {
  for (const int faceSize : {16, 64}) {
    for (const PrefilterSettings& settings : {PrefilterSettings{}, frosty()}) {
      const CubeMap chain = prefilterCube(cubeOf(faceSize, [](const glm::vec3&) { return glm::vec3(1.7f); }), settings);
      for (int level = 0; level < chain.levels(); ++level) {
        forEachTexel(chain.levelSize(level), [&](int face, int column, int row) {
          ASSERT_NEAR(chain.texel(level, face, column, row).y, 1.7f, 1e-4f) << faceSize << " level " << level;
          ASSERT_NEAR(chain.texel(level, face, column, row).w, 1.0f, 1e-4f);
        });
      }
    }
  }
}

TEST(Openings, OneTexelIsEnough) {
  CubeMap whole = cubeOf(4, [](const glm::vec3&) { return glm::vec3(0.3f); });
  EXPECT_FALSE(anyOpening(whole)) << "else a closed room pays for the sky";
  for (const auto& [face, column, row] : {std::tuple(0, 0, 0), {2, 3, 1}, {5, 3, 3}}) {
    CubeMap open = whole;
    open.setTexel(0, face, column, row, glm::vec4(0.3f, 0.3f, 0.3f, 0.999f));
    EXPECT_TRUE(anyOpening(open)) << face;
  }
}

// Whatever the colour, the same numbers: patches stand where their light is.
TEST(Prefilter, TheReferenceWeighsColoursAlike) {
  const FilterLobe lobe = lobeOfLevel({}, 3, 5);
  float values[3][20];
  for (int c = 0; c < 3; ++c) {
    const CubeMap source = cubeOf(64, [c](const glm::vec3& d) {
      glm::vec3 color(0.0f);
      color[c] = 0.2f + (std::sin(37.0f * d.x + 23.0f * d.y - 11.0f * d.z) > 0.7f ? 30.0f : 0.0f);
      return color;
    });
    const CubeFilterReference reference(source, 0.9f);
    for (int i = 0; i < 20; ++i) {
      const float angle = 0.7f * static_cast<float>(i), up = 0.1f * static_cast<float>(i) - 0.95f;
      const glm::vec3 direction(std::cos(angle), up, std::sin(angle));
      values[c][i] = reference.value(lobe, glm::normalize(direction))[c];
    }
  }
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(values[1][i], values[0][i]);
    EXPECT_EQ(values[2][i], values[0][i]);
  }
}

// In the middle of a face, at an edge, in a corner: texels there differ five times in solid angle. The lamp of one
// texel gives a third of all light.
TEST(Prefilter, KeepsEnergyWhereverTheLampIs) {
  for (const auto& [column, row] : {std::pair(0.5f, 0.5f), {0.1f, 0.6f}, {0.3f, 0.999f}, {0.999f, 0.999f}}) {
    const CubeMap source = skyWithLamp(128, column, row, 2.5e4f);
    const CubeMap chain = prefilterCube(source, {});
    for (int level = 1; level < chain.levels(); ++level) {
      EXPECT_NEAR(energy(chain, level) / energy(source, 0), 1.0, 0.01) << column << ' ' << row << " level " << level;
    }
  }
}

// Steps from texel to texel, across edges as within faces, are those of the reference: neither a seam nor a blotch.
TEST(Prefilter, NeitherSeamsNorSparkles) {
  for (const float column : {0.3f, 0.97f}) {
    const CubeMap source = skyWithLamp(64, column, 0.6f);
    const CubeMap chain = prefilterCube(source, {}), reference = referenceChain(source, {});
    for (int level = 1; level < chain.levels(); ++level) {
      const int size = chain.levelSize(level);
      const auto contrast = [](float a, float b) { return std::abs(a - b) / (a + b); };
      double worst = 0.0, worstAtEdges = 0.0;
      forEachTexel(size, [&](int face, int x, int y) {
        for (const bool below : {false, true}) {
          const float ours = contrast(chain.texel(level, face, x, y).x, neighbour(chain, level, face, x, y, below).x);
          const float truth =
              contrast(reference.texel(level, face, x, y).x, neighbour(reference, level, face, x, y, below).x);
          const double more = ours - truth;
          worst = std::max(worst, more);
          if ((below ? y : x) == size - 1) worstAtEdges = std::max(worstAtEdges, more);
        }
      });
      EXPECT_LT(worst, 0.2) << "level " << level;
      EXPECT_LT(worstAtEdges, 0.15) << "level " << level;
    }
  }
}

TEST(Prefilter, ErrorFallsWithSamples) {
  const CubeMap source = skyWithLamp(64, 0.7f, 0.6f);
  const CubeMap reference = referenceChain(source, {});
  PrefilterSettings few, many;
  few.samples = 16;
  many.samples = 240;
  const CubeMap rough = prefilterCube(source, few), fine = prefilterCube(source, many);
  for (int level = 1; level < reference.levels(); ++level) {
    EXPECT_LT(errorOfLevel(fine, reference, level), 0.05) << "level " << level;
    EXPECT_LT(errorOfLevel(fine, reference, level), errorOfLevel(rough, reference, level)) << "level " << level;
  }
}

// The reference itself against plain importance sampling of the source's level 0 with 16,384 samples, which shares only
// the kernel with it: directions and weights are written down here again.
TEST(PrefilterReference, AgreesWith16kSamples) {
  const CubeMap source = cubeOf(32, [](const glm::vec3& d) {
    return glm::vec3(d.x > 0.8f ? 20.0f : 1.0f, 1.0f + 0.5f * std::sin(9.0f * d.y), 2.0f + d.z);
  });
  const CubeFilterReference reference(source);
  constexpr int kSamples = 16384;
  for (const double alpha : {0.1, 0.3, 1.0}) {
    for (const glm::vec3& middle : {glm::normalize(glm::vec3(1, 0.3f, 0.2f)), glm::normalize(glm::vec3(-1, 1, 1))}) {
      const glm::vec3 t = shading::lobeTangent(middle), b = shading::lobeBitangent(middle);
      glm::dvec4 sum(0.0);
      double weight = 0.0;
      for (int i = 0; i < kSamples; ++i) {
        const double u = (i + 0.5) / kSamples, phi = 6.283185307179586 * std::fmod(i * 0.6180339887498949, 1.0);
        const double half = std::atan(alpha * std::sqrt(u / (1.0 - u)));
        const double z = std::cos(2.0 * half), r = std::sin(2.0 * half);
        if (z <= 0.0) continue;
        const glm::vec3 d = float(r * std::cos(phi)) * t + float(r * std::sin(phi)) * b + float(z) * middle;
        sum += z * glm::dvec4(source.fetch(d, 0.0f));
        weight += z;
      }
      const glm::dvec4 expected = sum / weight;
      const glm::vec4 value = reference.value({FilterLobe::Kind::Ggx, static_cast<float>(alpha)}, middle);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c] / expected[c], 1.0, 5e-3) << alpha << " channel " << c;
    }
  }
}

TEST(LobeFrame, IsOrthonormalUpToThePole) {
  for (const glm::vec3& d : {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0, -1, 1e-7f),
                             glm::vec3(1e-3f, 5e-4f, -1), glm::vec3(-2e-4f, 1e-4f, -1), glm::vec3(1, 2, -3)}) {
    const glm::vec3 n = glm::normalize(d), t = shading::lobeTangent(n), b = shading::lobeBitangent(n);
    EXPECT_NEAR(glm::dot(t, t), 1.0f, 2e-3f);
    EXPECT_NEAR(glm::dot(b, b), 1.0f, 2e-3f);
    EXPECT_NEAR(glm::dot(t, b), 0.0f, 2e-3f);
    EXPECT_NEAR(glm::dot(t, n), 0.0f, 1e-3f);
    EXPECT_NEAR(glm::dot(glm::cross(t, b), n), 1.0f, 2e-3f);
  }
}

// CubeMapGen's angles hold three standard deviations to either side; a level is blurred on top of the one before it.
TEST(Frosty, WidthsFollowTheLaw) {
  const PrefilterSettings settings = frosty();
  constexpr double kDegree = 3.14159265358979 / 180.0;
  double variance = std::pow(8.0 / 6.0 * kDegree, 2.0), cone = 5.0;
  EXPECT_NEAR(lobeOfLevel(settings, 0, 6).width, std::sqrt(variance), 1e-6);
  for (int level = 1; level <= 6; ++level, cone *= 2.0) {
    variance += std::pow(cone / 6.0 * kDegree, 2.0);
    EXPECT_NEAR(lobeOfLevel(settings, level, 6).width, std::sqrt(variance), 1e-6) << level;
  }
}

// How far the light of one texel is spread by each level's lookups, measured with more texels than the level has: it is
// narrower than them. The mean of angle² / 2 is a Gaussian's variance, less 2.5 % by the cut at three deviations, and
// more by the interpolation of the texel itself.
TEST(Frosty, ALampIsSpreadAsWideAsTheLawSays) {
  constexpr int kSize = 64, kColumn = 35, kRow = 29;
  CubeMap source(kSize, fullLevels(kSize)), blurred(kSize, 1);
  source.setTexel(0, 2, kColumn, kRow, glm::vec4(1.0e4f));
  makeSourceLevels(source);
  const glm::vec3 lamp = texelDirection(kSize, 2, kColumn, kRow);
  for (const int level : {0, 1, 2, 4}) {
    const FilterLobe lobe = lobeOfLevel(frosty(), level, 6);
    filterCubeLevel(source, blurred, 0, lobeTaps(lobe, samplesOfLevel(frosty(), level), kSize));
    double sum = 0.0, weight = 0.0;
    forEachTexel(kSize, [&](int face, int column, int row) {
      const double cosine = glm::dot(lamp, texelDirection(kSize, face, column, row));
      const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
      const double w = texelSolidAngle(kSize, column, row) * blurred.texel(0, face, column, row).x;
      sum += w * 0.5 * angle * angle;
      weight += w;
    });
    const double variance = 0.975 * lobe.width * lobe.width + std::pow(2.0 / kSize, 2.0) / 6.0;
    EXPECT_NEAR(std::sqrt(sum / weight / variance), 1.0, 0.04) << "level " << level;
  }
}

TEST(Frosty, EdgeFixupMakesTheTwoSidesOfAnEdgeEqual) {
  PrefilterSettings with = frosty(), without = frosty();
  with.gaussian.edgeFixupWidth = 4;
  const CubeMap source = skyWithLamp(32, 0.97f, 0.6f);
  const CubeMap fixed = prefilterCube(source, with), plain = prefilterCube(source, without);
  double stepFixed = 0.0, stepPlain = 0.0;
  for (int level = 0; level < fixed.levels(); ++level) {
    const int last = fixed.levelSize(level) - 1;
    for (int face = 0; face < 6; ++face) {
      for (int i = 0; i <= last; ++i) {
        for (const bool below : {false, true}) {
          const int column = below ? i : last, row = below ? last : i;
          const float value = fixed.texel(level, face, column, row).x;
          stepFixed =
              std::max<double>(stepFixed, std::abs(neighbour(fixed, level, face, column, row, below).x / value - 1));
          const float before = plain.texel(level, face, column, row).x;
          stepPlain =
              std::max<double>(stepPlain, std::abs(neighbour(plain, level, face, column, row, below).x / before - 1));
        }
      }
    }
    // Farther inside than its width nothing changes.
    const int middle = (last + 1) / 2;
    if (last - middle >= with.gaussian.edgeFixupWidth) {
      EXPECT_EQ(fixed.texel(level, 4, middle, middle), plain.texel(level, 4, middle, middle));
    }
  }
  EXPECT_LT(stepFixed, 1e-3);
  EXPECT_GT(stepPlain, 0.05);
}

}  // namespace
