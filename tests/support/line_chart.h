// Curves over a common abscissa as a picture: what a test measured along a way, to look at.
#pragma once

#include <string>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe::test {

struct Curve {
  std::string name;
  std::vector<double> values;
  unsigned char color[3];
};

ImageRgba8 lineChart(const std::string& title, const std::string& abscissa, const std::vector<double>& at,
                     const std::vector<Curve>& curves);

}  // namespace boxprobe::test
