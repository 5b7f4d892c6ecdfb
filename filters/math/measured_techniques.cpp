// What `boxprobe bench` measured, for `auto`. To measure again: `boxprobe bench`, whose report ends with these rows.
#include "filters/math/automatic.h"

namespace boxprobe {

const std::vector<MeasuredTechnique>& measuredTechniques() {
  static const std::vector<MeasuredTechnique> rows = {
      {"box", 0.99, {0.0, 0.0333, 0.0581, 0.0751, 0.0812, 0.0837}},
      {"hdrp", 1.0, {0.0, 0.0255, 0.0461, 0.0687, 0.0803, 0.0837}},
      {"footprint1", 1.46, {0.0, 0.0226, 0.0388, 0.0500, 0.0601, 0.0706}},
      {"footprint2", 1.94, {0.0, 0.0205, 0.0299, 0.0353, 0.0416, 0.0502}},
      {"footprint4", 3.33, {0.0, 0.0175, 0.0254, 0.0293, 0.0329, 0.0344}},
      {"footprint8", 6.55, {0.0, 0.0149, 0.0215, 0.0229, 0.0239, 0.0255}},
      {"footprint16", 11.32, {0.0, 0.0120, 0.0179, 0.0182, 0.0194, 0.0215}},
  };
  return rows;
}

}  // namespace boxprobe
