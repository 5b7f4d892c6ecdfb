// The published techniques and the ray-traced form in rooms that are boxes, against the integral of the lobe: how far
// each is off, over HDRP's error, which is the order that users of those techniques know them by. The integral is a
// plain evaluation in double precision that shares nothing with the shader files.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "filters/math/technique/technique_table.h"
#include "filters/reference/study/study_tally.h"

namespace boxprobe {
namespace {

struct Form {
  const char* id;
  float samples = 64.0f;
  int levelOffset = 0, filtered = 0;
  std::string name() const {
    return std::string(id) + (levelOffset != 0 ? " levelOffset" : "") + (filtered != 0 ? " filtered" : "");
  }
};

glm::dvec3 valueOf(const Form& form, const study::RoomPoint& at) {
  const Technique technique = parseTechnique(form.id).value();
  shading::ProbeShape probe = at.probe;
  probe.projection = technique.projection;
  probe.parameters.samples = form.samples;
  probe.parameters.levelOffset = form.levelOffset;
  probe.parameters.filtered = form.filtered;
  return glm::dvec3(
      evaluationRows()[static_cast<std::size_t>(technique.evaluation)].evaluate(at.chain, probe, at.point));
}

TEST(PublishedTechniques, StandInTheOrderTheyAreKnownBy) {
  const std::vector<Form> forms = {{"infinite"},
                                   {"sphere"},
                                   {"approximate"},
                                   {"box"},
                                   {"godot"},
                                   {"hdrp"},
                                   {"raytraced"},
                                   {"raytraced", 64.0f, 1, 0},
                                   {"raytraced", 64.0f, 0, 1}};
  const study::RoomPoints rooms = study::randomPoints(23, 6, 16, 128, 4096);
  std::map<std::string, double> errors;
  for (const Form& form : forms) {
    const auto technique = [&form](const study::RoomPoint& at) { return valueOf(form, at); };
    errors[form.name()] = study::tally(study::valuesOf(technique, rooms.points), rooms.points).rmse;
  }
  const auto ratio = [&](const std::string& name) { return errors[name] / errors["hdrp"]; };
  for (const Form& form : forms) {
    std::printf("  %-24s error %.4f, over hdrp's %.2f\n", form.name().c_str(), errors[form.name()], ratio(form.name()));
  }
  EXPECT_GT(ratio("infinite"), ratio("sphere"));
  EXPECT_GT(ratio("sphere"), ratio("approximate"));
  EXPECT_GT(ratio("approximate"), ratio("box"));
  EXPECT_NEAR(ratio("godot"), 1.0, 0.1);
  EXPECT_GT(ratio("box"), 0.98);
  EXPECT_GT(ratio("raytraced"), 1.5 * ratio("raytraced levelOffset")) << "64 rays alone leave ghosts of small lamps";
  EXPECT_GT(ratio("raytraced levelOffset"), 1.5 * ratio("raytraced filtered"));
}

// Rays without any filter, over many pixels: what they average to is the integral itself.
TEST(PublishedTechniques, RaysAverageToTheIntegral) {
  const study::RoomPoints room = study::randomPoints(4, 1, 3, 64, 1 << 17);
  for (study::RoomPoint at : room.points) {
    if (at.point.roughness < 0.3f) continue;
    glm::dvec3 sum(0.0), squares(0.0);
    constexpr int kPixels = 32;
    for (int y = 0; y < kPixels; ++y) {
      for (int x = 0; x < kPixels; ++x) {
        at.point.pixel = {x, y};
        const glm::dvec3 value = valueOf({"raytraced", 64.0f}, at);
        sum += value;
        squares += value * value;
      }
    }
    const double count = kPixels * kPixels;
    for (int c = 0; c < 3; ++c) {
      const double mean = sum[c] / count;
      const double standardError = std::sqrt(std::max(squares[c] / count - mean * mean, 0.0) / count);
      // A quotient of sums is off by a share of its variance; 64 samples leave about a hundredth of that.
      EXPECT_NEAR(mean, at.truth[c], 4.0 * standardError + 0.01 * at.truth[c]) << "roughness " << at.point.roughness;
    }
  }
}

}  // namespace
}  // namespace boxprobe
