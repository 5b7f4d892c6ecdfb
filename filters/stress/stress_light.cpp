// See stress_light.h.
#include "filters/stress/stress_light.h"

#include "filters/stress/stress_random.h"

namespace boxprobe::stress {

const LightTable& stressLightTable() {
  static const LightTable table = [] {
    constexpr int kFace = 4, kBlackFace = 3;
    CubeMap capture(kFace, 1);
    StressRandom random(idHash("light"));
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < kFace; ++row) {
        for (int column = 0; column < kFace; ++column) {
          const float light = face == kBlackFace ? 0.0f : static_cast<float>(random.logBetween(0.01, 10.0));
          capture.setTexel(0, face, column, row, glm::vec4(light, light, light, 1.0f));
        }
      }
    }
    capture.setTexel(0, 2, 1, 2, glm::vec4(glm::vec3(1.0e4f), 1.0f));
    return makeLightTable(capture);
  }();
  return table;
}

}  // namespace boxprobe::stress
