// What `boxprobe bench` measured, for `auto`. To measure again: `boxprobe bench`, whose report ends with these rows.
#include "filters/math/automatic.h"

namespace boxprobe {

const std::vector<MeasuredTechnique>& measuredTechniques() {
  static const std::vector<MeasuredTechnique> rows = {
      {"box", 1.0, {0.0, 0.057, 0.088, 0.101, 0.112, 0.118}},
      {"footprint1", 1.4, {0.0, 0.027, 0.042, 0.057, 0.077, 0.095}},
      {"footprint2", 2.0, {0.0, 0.022, 0.035, 0.041, 0.050, 0.068}},
      {"footprint4", 3.0, {0.0, 0.020, 0.030, 0.033, 0.039, 0.048}},
      {"footprint8", 5.0, {0.0, 0.018, 0.027, 0.027, 0.032, 0.038}},
      {"footprint16", 9.0, {0.0, 0.018, 0.022, 0.020, 0.024, 0.031}},
  };
  return rows;
}

}  // namespace boxprobe
