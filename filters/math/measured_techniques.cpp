// What `boxprobe bench` measured, for `auto`. To measure again: `boxprobe bench`, whose report ends with these rows.
#include "filters/math/automatic.h"

namespace boxprobe {

const std::vector<MeasuredTechnique>& measuredTechniques() {
  static const std::vector<MeasuredTechnique> rows = {
      {"box", 0.79, {0.0000, 0.0343, 0.0534, 0.0699, 0.0753, 0.0792}},
      {"hdrp", 0.94, {0.0000, 0.0260, 0.0426, 0.0640, 0.0742, 0.0792}},
      {"footprint1", 1.80, {0.0000, 0.0230, 0.0334, 0.0445, 0.0508, 0.0607}},
      {"footprint2", 1.90, {0.0000, 0.0191, 0.0266, 0.0333, 0.0398, 0.0489}},
      {"footprint4", 3.52, {0.0000, 0.0165, 0.0223, 0.0275, 0.0319, 0.0346}},
      {"footprint8", 6.44, {0.0000, 0.0141, 0.0186, 0.0208, 0.0213, 0.0241}},
      {"footprint16", 11.68, {0.0000, 0.0116, 0.0159, 0.0166, 0.0174, 0.0197}},
  };
  return rows;
}

}  // namespace boxprobe
