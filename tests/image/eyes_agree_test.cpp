// When placing believes a small gain: what single eyes gain.
#include <gtest/gtest.h>

#include <vector>

#include "app/session/picture_check.h"

namespace boxprobe {
namespace {

// Gains of 0.4, 0.3 and 0.2, twice: mean 0.3, standard error 0.037. Of 0.9, 0.1 and -0.1, twice: 0.3 and 0.194.
TEST(EyesAgree, WhereEachGainsAboutAsMuch) {
  const std::vector<double> after = {2.0, 1.0, 3.0, 2.0, 1.0, 3.0};
  const auto before = [&](double a, double b, double c) {
    return std::vector<double>{2.0 + a, 1.0 + b, 3.0 + c, 2.0 + a, 1.0 + b, 3.0 + c};
  };
  EXPECT_TRUE(eyesAgree(before(0.4, 0.3, 0.2), after));
  EXPECT_FALSE(eyesAgree(after, before(0.4, 0.3, 0.2))) << "it is worse";
  EXPECT_FALSE(eyesAgree(before(0.9, 0.1, -0.1), after)) << "two eyes alone";
  EXPECT_FALSE(eyesAgree({2.4, 1.3, 3.2, 2.4, 1.3}, {2.0, 1.0, 3.0, 2.0, 1.0})) << "five tell too little";
  // Standard errors 0.153 and 0.145.
  EXPECT_FALSE(eyesAgree(before(0.785, 0.06, 0.055), after));
  EXPECT_TRUE(eyesAgree(before(0.757, 0.07, 0.073), after));
}

}  // namespace
}  // namespace boxprobe
