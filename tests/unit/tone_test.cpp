// The tone curves against three.js, whose own shader text made tests/unit/tone_values.txt in Chromium:
//   tests/outside/with_engines.sh build/release/tests/outside/engines chromium tone_values.mjs
//   tests/unit/tone_values.txt
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <vector>

#include "filters/math/shared/display_math.h"
#include "tests/support/shown_light.h"

namespace boxprobe::test {
namespace {

constexpr std::array<Tone, 3> kTones = {Tone::Neutral, Tone::Agx, Tone::Aces};

struct Judged {
  glm::vec3 light{0.0f};
  std::array<glm::vec3, 3> shown{};  ///< linear, in the order of kTones
};

std::vector<Judged> judgedColors() {
  std::ifstream file(BOXPROBE_SOURCE_DIR "/tests/unit/tone_values.txt");
  std::vector<Judged> colors;
  for (Judged c; file >> c.light.x >> c.light.y >> c.light.z; colors.push_back(c)) {
    for (glm::vec3& shown : c.shown) {
      file >> shown.x >> shown.y >> shown.z;
      shown /= 10000.0f;
    }
  }
  return colors;
}

TEST(Tone, IsThatOfThreeJs) {
  const std::vector<Judged> colors = judgedColors();
  ASSERT_EQ(colors.size(), 1000u);
  for (std::size_t k = 0; k < kTones.size(); ++k) {
    double worst = 0.0;
    for (const Judged& c : colors) {
      const glm::vec3 ours = toneMapped(c.light, kTones[k]);
      for (int i = 0; i < 3; ++i) {
        const double off = 255.0 * (shownLight(ours[i]) - shownLight(c.shown[k][i]));
        worst = std::max(worst, std::abs(off));
      }
    }
    std::printf("  tone %d: at most %.3f of 255 off\n", static_cast<int>(kTones[k]), worst);
    // A step of the file's numbers is 0.33 of 255 where it is dark.
    EXPECT_LT(worst, 0.5) << static_cast<int>(kTones[k]);
  }
}

TEST(Tone, NoneCutsOffAtWhite) {
  for (const Tone tone : {Tone::None, Tone::AsVtk}) {
    const glm::vec3 shown = toneMapped({0.37f, 1.4f, -0.2f}, tone);
    EXPECT_EQ(shown, glm::vec3(0.37f, 1.0f, 0.0f));
  }
}

// The background colour is shown as it was chosen, whatever the tone: of colours that three.js got.
TEST(Tone, FindsTheLightOfAColour) {
  const std::vector<Judged> colors = judgedColors();
  for (std::size_t k = 0; k < kTones.size(); ++k) {
    int judged = 0;
    double worst = 0.0;
    for (const Judged& c : colors) {
      const glm::vec3 shown = c.shown[k];
      if (std::max({shown.x, shown.y, shown.z}) > 0.9f || std::min({shown.x, shown.y, shown.z}) < 0.01f) continue;
      const glm::vec3 again = toneMapped(lightShownAs(shown, kTones[k]), kTones[k]);
      for (int i = 0; i < 3; ++i)
        worst = std::max(worst, 255.0 * std::abs(shownLight(again[i]) - shownLight(shown[i])));
      ++judged;
    }
    EXPECT_GT(judged, 200) << static_cast<int>(kTones[k]);
    EXPECT_LT(worst, 1.0) << static_cast<int>(kTones[k]);
  }
  const glm::vec3 shown(0.61f, 0.23f, 0.09f);
  for (const Tone tone : {Tone::None, Tone::AsVtk}) EXPECT_EQ(lightShownAs(shown, tone), shown);
}

// Specification of Khronos PBR Neutral: what is not bright, less what a dielectric reflects, stays as it is.
TEST(Tone, NeutralKeepsBaseColours) {
  const glm::vec3 base(0.61f, 0.23f, 0.09f);
  const glm::vec3 shown = toneMapped(base + 0.04f, Tone::Neutral);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(shown[i], base[i], 1e-6);
}

// Brighter light is never shown darker, and white is reached and not passed.
TEST(Tone, RisesFromBlackToWhite) {
  for (const Tone tone : kTones) {
    EXPECT_LT(toneMapped(glm::vec3(0.0f), tone).x, 1e-3f);
    float before = -1.0f;
    for (double stop = -9.0; stop < 9.0; stop += 0.03) {
      const float shown = toneMapped(glm::vec3(static_cast<float>(0.3 * std::exp2(stop))), tone).y;
      EXPECT_GE(shown, before - 1e-5f) << static_cast<int>(tone) << " at " << stop;
      before = shown;
    }
    EXPECT_GT(before, 0.98f);
    EXPECT_LE(before, 1.0f);
  }
}

TEST(Tone, GivesColoursOfAnyLight) {
  const float huge = std::numeric_limits<float>::infinity();
  for (const Tone tone : kTones) {
    for (const glm::vec3& light : {glm::vec3(huge, 0.2f, 0.0f), glm::vec3(huge), glm::vec3(1e38f, 3e37f, 2.0f),
                                   glm::vec3(-1.0f, -0.3f, 0.4f), glm::vec3(0.0f)}) {
      const glm::vec3 shown = toneMapped(light, tone);
      for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(shown[i] >= 0.0f && shown[i] <= 1.0f) << static_cast<int>(tone) << ": " << shown[i];
      }
    }
  }
}

}  // namespace
}  // namespace boxprobe::test
