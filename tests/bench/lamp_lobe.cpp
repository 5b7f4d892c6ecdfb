// Glossy light of polygon lamps against quadrature: `lamp_lobe [LAMPS]`, 60 lamps a row unless said otherwise. Of
// shaders/shared/lamp.glsl by roughness and by the elevation that a floor is seen under: rms error over rms light, and
// mean light over the truth's, of metals (F0 = F90 = 1) and of non-metals (F0 = 0.04). Beside it, in brackets, linearly
// transformed cosines, fitted for each row.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/trigonometric.hpp>

#include "tests/bench/ltc_lobe.h"
#include "tests/support/lamp_truth.h"

namespace boxprobe {
namespace {

struct Tally {
  double off = 0.0, whole = 0.0, light = 0.0, trueLight = 0.0;
  void add(double found, double truth) {
    off += (found - truth) * (found - truth);
    whole += truth * truth;
    light += found;
    trueLight += truth;
  }
  double error() const { return std::sqrt(off / whole); }
  double ratio() const { return light / trueLight; }
};

void row(double roughness, double degrees, int lamps) {
  std::mt19937 random(static_cast<unsigned>(1000.0 * roughness + degrees));
  const test::LtcLobe ltc = test::fitLtc(roughness, glm::radians(degrees));
  Tally metal, dielectric, ltcMetal, ltcDielectric;
  for (int i = 0; i < lamps; ++i) {
    const test::LampCase lamp = test::randomFloorLamp(random, glm::radians(degrees));
    const glm::dvec2 truth = test::trueGlossy(lamp, roughness);
    const LampPolygon polygon = lamp.polygon();
    const shading::LampLobe lobe =
        shading::lampLobe(glm::vec3(lamp.normal), glm::vec3(lamp.view), static_cast<float>(roughness));
    const glm::dvec2 found(shading::lampGlossy(&polygon, glm::vec3(0.0f), lobe));
    metal.add(found.x + found.y, truth.x + truth.y);
    dielectric.add(0.04 * found.x + found.y, 0.04 * truth.x + truth.y);
    const glm::dvec2 cosines = ltc.glossy(lamp);
    ltcMetal.add(cosines.x + cosines.y, truth.x + truth.y);
    ltcDielectric.add(0.04 * cosines.x + cosines.y, 0.04 * truth.x + truth.y);
  }
  std::printf("| %g | %g | %.3f (%.3f) | %.3f (%.3f) | %.3f (%.3f) | %.3f (%.3f) |\n", roughness, degrees,
              metal.error(), ltcMetal.error(), metal.ratio(), ltcMetal.ratio(), dielectric.error(),
              ltcDielectric.error(), dielectric.ratio(), ltcDielectric.ratio());
  std::fflush(stdout);
}

}  // namespace
}  // namespace boxprobe

int main(int argc, char** argv) {
  const int lamps = argc > 1 ? std::atoi(argv[1]) : 60;
  if (lamps < 1) {
    std::fprintf(stderr, "lamp_lobe: the number of lamps must be at least 1\n");
    return 2;
  }
  std::printf(
      "| roughness | elevation | metal (LTC) | light | dielectric (LTC) | light |\n|---|---|---|---|---|---|\n");
  for (const double roughness : {0.15, 0.25, 0.35, 0.5, 0.6, 0.75, 1.0}) {
    for (const double degrees : {8.0, 10.0, 15.0, 22.0, 30.0, 40.0, 70.0}) boxprobe::row(roughness, degrees, lamps);
  }
  return 0;
}
