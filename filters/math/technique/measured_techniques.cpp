// Results of `boxprobe bench` for `auto`. To measure again, run it: its report ends with these rows.
#include "filters/math/technique/automatic.h"

namespace boxprobe {

const std::vector<MeasuredTechnique>& measuredTechniques() {
  static const std::vector<MeasuredTechnique> rows = {
      {"box", 0.95, {0.0000, 0.0343, 0.0534, 0.0699, 0.0753, 0.0792}},
      {"hdrp", 1.06, {0.0000, 0.0260, 0.0426, 0.0640, 0.0742, 0.0792}},
      {"footprint1", 1.73, {0.0000, 0.0230, 0.0342, 0.0445, 0.0508, 0.0607}},
      {"footprint2", 2.42, {0.0000, 0.0191, 0.0274, 0.0333, 0.0398, 0.0489}},
      {"footprint4", 3.96, {0.0000, 0.0165, 0.0223, 0.0275, 0.0319, 0.0346}},
      {"footprint8", 7.19, {0.0000, 0.0139, 0.0184, 0.0208, 0.0212, 0.0242}},
      {"footprint16", 13.15, {0.0000, 0.0105, 0.0148, 0.0163, 0.0173, 0.0193}},
  };
  return rows;
}

}  // namespace boxprobe
