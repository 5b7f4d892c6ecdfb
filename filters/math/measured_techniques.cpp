// What `boxprobe bench` measured, for `auto`. To measure again: `boxprobe bench`, whose report ends with these rows.
#include "filters/math/automatic.h"

namespace boxprobe {

const std::vector<MeasuredTechnique>& measuredTechniques() {
  static const std::vector<MeasuredTechnique> rows = {
      {"box", 0.99, {0.0, 0.0330, 0.0560, 0.0720, 0.0780, 0.0800}},
      {"hdrp", 1.0, {0.0, 0.0261, 0.0427, 0.0641, 0.0741, 0.0792}},
      {"footprint1", 1.46, {0.0, 0.0229, 0.0334, 0.0445, 0.0508, 0.0607}},
      {"footprint2", 1.94, {0.0, 0.0191, 0.0263, 0.0333, 0.0398, 0.0489}},
      {"footprint4", 3.33, {0.0, 0.0165, 0.0223, 0.0275, 0.0318, 0.0346}},
      {"footprint8", 6.55, {0.0, 0.0141, 0.0186, 0.0208, 0.0213, 0.0241}},
      {"footprint16", 11.32, {0.0, 0.0116, 0.0159, 0.0166, 0.0174, 0.0197}},
  };
  return rows;
}

}  // namespace boxprobe
