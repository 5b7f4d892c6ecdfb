// The formulas of a material's finish against what they stand for: integrals, limits, and a film calculated wave by
// wave.
#include "filters/math/shared/finish_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <glm/geometric.hpp>

#include "filters/reference/light/sheen_light.h"
#include "filters/reference/trace/visible_normal_lobe.h"

namespace boxprobe {
namespace {

constexpr double kFinishPi = 3.14159265358979323846;

TEST(FinishMath, SheenFitKeepsToItsIntegral) {
  double sum = 0.0, most = 0.0;
  int count = 0;
  for (double r = 0.07; r <= 1.0; r += 0.03) {
    for (double c = 0.02; c <= 1.0; c += 0.02, ++count) {
      const double off = std::abs(
          static_cast<double>(shading::sheenAlbedo(static_cast<float>(c), static_cast<float>(r))) - sheenShare(c, r));
      sum += off;
      most = std::max(most, off);
    }
  }
  std::printf("  off by %.4f on average, %.4f at most\n", sum / count, most);
  EXPECT_LT(sum / count, 0.008);
  EXPECT_LT(most, 0.06);
}

TEST(FinishMath, SheenIsTheSameBothWays) {
  for (const float r : {0.1f, 0.4f, 1.0f}) {
    EXPECT_FLOAT_EQ(shading::sheenLobe(0.5f, 0.2f, 0.9f, r), shading::sheenLobe(0.5f, 0.9f, 0.2f, r));
  }
}

TEST(FinishMath, TheSheensStrongestColourTakesFromTheLayersBelow) {
  for (const glm::vec3& color :
       {glm::vec3(0.9f, 0.5f, 0.3f), glm::vec3(0.3f, 0.9f, 0.5f), glm::vec3(0.5f, 0.3f, 0.9f)}) {
    EXPECT_NEAR(static_cast<double>(shading::underSheen(color, 0.37f, 0.6f)), 1.0 - 0.9 * sheenShare(0.37, 0.6), 0.02);
  }
}

TEST(FinishMath, BrushedWithoutStrengthIsRoundAbout) {
  const float alpha = 0.3f, a2 = alpha * alpha;
  const glm::vec3 v = glm::normalize(glm::vec3(0.4f, -0.2f, 0.7f)), l = glm::normalize(glm::vec3(-0.1f, 0.5f, 0.6f)),
                  h = glm::normalize(v + l);
  const float d = h.z * h.z * (a2 - 1.0f) + 1.0f;
  const float masking =
      0.5f / (l.z * std::sqrt(a2 + v.z * v.z * (1.0f - a2)) + v.z * std::sqrt(a2 + l.z * l.z * (1.0f - a2)));
  EXPECT_NEAR(shading::anisotropicLobe(v, l, h, shading::anisotropicAlpha(alpha, 0.0f)),
              a2 / (3.14159265f * d * d) * masking, 1e-5f);
  const glm::vec3 n(0.0f, 0.0f, 1.0f);
  EXPECT_LT(glm::length(shading::anisotropicNormal(n, v, {0.0f, 1.0f, 0.0f}, 0.5f, 0.0f) - n), 1e-6f);
}

// The reference's lobe: what it draws is as dense as it says, and even light comes back the same either way.
TEST(FinishMath, BrushedLobeDrawsAsDenselyAsItSays) {
  const glm::dvec3 n(0.0, 0.0, 1.0), across = glm::normalize(glm::dvec3(1.0, 2.0, 0.0)),
                                     view = glm::normalize(glm::dvec3(0.6, 0.3, 0.5));
  const VisibleNormalLobe lobe(n, across, view, 0.7, 0.15);
  double byDensity = 0.0, reflected = 0.0;
  constexpr int kSteps = 800;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const double z = (i + 0.5) / kSteps, turn = 2.0 * kFinishPi * (j + 0.5) / kSteps, flat = std::sqrt(1.0 - z * z);
      const auto of = lobe.at({flat * std::cos(turn), flat * std::sin(turn), z});
      byDensity += of.density * 2.0 * kFinishPi / (kSteps * kSteps);
      reflected += of.density * of.weight * 2.0 * kFinishPi / (kSteps * kSteps);
    }
  }
  const ShiftedPoints points(3);
  double drawn = 0.0, weights = 0.0;
  constexpr int kRays = 40000;
  for (int i = 0; i < kRays; ++i) {
    const auto s = lobe.sample(points[i]);
    drawn += s.weight > 0.0 ? 1.0 / kRays : 0.0;
    weights += s.weight / kRays;
    if (i % 1000 == 0 && s.weight > 0.0) {
      EXPECT_NEAR(lobe.at(s.direction).weight, s.weight, 1e-9);
    }
  }
  EXPECT_NEAR(byDensity, drawn, 2e-3);
  EXPECT_NEAR(reflected, weights, 2e-3);
}

// Light of one wave and one polarisation off a film: Airy's sum, in closed form.
double airy(double cosine, double film, double base, double phase, bool parallel) {
  const auto inside = [&](double index) { return std::sqrt(1.0 - (1.0 - cosine * cosine) / (index * index)); };
  const auto amplitude = [&](double from, double to) {
    const double c = inside(from), t = inside(to);
    return parallel ? (to * c - from * t) / (to * c + from * t) : (from * c - to * t) / (from * c + to * t);
  };
  const std::complex<double> turned = std::polar(1.0, phase);
  const double outer = amplitude(1.0, film), inner = amplitude(film, base);
  return std::norm((outer + inner * turned) / (1.0 + outer * inner * turned));
}

double bump(double wave, double middle, double below, double above) {
  const double x = (wave - middle) / (wave < middle ? below : above);
  return std::exp(-0.5 * x * x);
}

// The CIE's curves of 1931 (fit of Wyman, Sloan and Shirley 2013), waves in nanometres.
glm::dvec3 matching(double w) {
  return {1.056 * bump(w, 599.8, 37.9, 31.0) + 0.362 * bump(w, 442.0, 16.0, 26.7) - 0.065 * bump(w, 501.1, 20.4, 26.2),
          0.821 * bump(w, 568.8, 46.9, 40.5) + 0.286 * bump(w, 530.9, 16.3, 31.1),
          1.217 * bump(w, 437.0, 11.8, 36.0) + 0.681 * bump(w, 459.0, 26.0, 13.8)};
}

// The published form cuts the series after two and takes Schlick's curve for Fresnel's. The convention is its own: the
// mean over all phases is white, what swings about it is weighed by the eye's curves.
glm::dvec3 filmByWaves(double base, double film, double thickness, double cosine) {
  const double within = std::sqrt(1.0 - (1.0 - cosine * cosine) / (film * film));
  const auto reflectance = [&](double phase) {
    return 0.5 * (airy(cosine, film, base, phase, true) + airy(cosine, film, base, phase, false));
  };
  double mean = 0.0;
  for (int i = 0; i < 720; ++i) mean += reflectance(2.0 * kFinishPi * i / 720.0) / 720.0;
  glm::dvec3 swing(0.0);
  double norm = 0.0;
  for (double w = 360.0; w <= 830.0; w += 0.5) {
    const glm::dvec3 m = matching(w);
    swing += m * (reflectance(2.0 * kFinishPi * 2.0 * film * thickness * within / w) - mean);
    norm += m.y;
  }
  swing /= norm;
  return {mean + glm::dot(swing, glm::dvec3(3.2404542, -1.5371385, -0.4985314)),
          mean + glm::dot(swing, glm::dvec3(-0.9692660, 1.8760108, 0.0415560)),
          mean + glm::dot(swing, glm::dvec3(0.0556434, -0.2040259, 1.0572252))};
}

TEST(FinishMath, FilmIsWhatItsWavesAddUpTo) {
  double most = 0.0;
  for (const double base : {1.2, 1.5, 2.4, 6.0}) {
    const double root = (base - 1.0) / (base + 1.0);
    for (const double film : {1.3, 1.8}) {
      for (double thickness = 100.0; thickness <= 600.0; thickness += 50.0) {
        for (const double cosine : {1.0, 0.8, 0.6}) {
          const glm::dvec3 waves = glm::max(filmByWaves(base, film, thickness, cosine), 0.0);
          const glm::dvec3 drawn(shading::filmReflectance(glm::vec3(static_cast<float>(root * root)),
                                                          static_cast<float>(film), static_cast<float>(thickness),
                                                          static_cast<float>(cosine)));
          const glm::dvec3 off = glm::abs(waves - drawn);
          most = std::max({most, off.x, off.y, off.z});
        }
      }
    }
  }
  std::printf("  off by %.3f of all light at most\n", most);
  EXPECT_LT(most, 0.08);
}

// But for what the swing at no path at all comes to in RGB: the curves make a white of equal energy reddish.
TEST(FinishMath, FilmThatVanishesLeavesItsBase) {
  const glm::vec3 base(0.04f, 0.5f, 0.9f);
  const glm::vec3 drawn = shading::filmReflectance(base, 1.3f, 0.0f, 0.7f);
  const float edge = std::pow(0.3f, 5.0f);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(drawn[i], base[i] + (1.0f - base[i]) * edge, 0.04f);
    EXPECT_NEAR(shading::filmNormalReflectance(drawn, 0.7f)[i], base[i], 0.04f);
  }
}

}  // namespace
}  // namespace boxprobe
