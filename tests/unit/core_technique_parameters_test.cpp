// What a scene says of a technique's parameters, as the mathematics reads it.
#include <gtest/gtest.h>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/scene/technique_parameters.h"

namespace boxprobe {
namespace {

TEST(TechniqueParameters, LeftOutTheyAreTheDefaults) {
  const auto values = probeGeometry(Probe{}, glm::dvec3(0.0)).parameters;
  EXPECT_EQ(values.curve, 0);
  EXPECT_EQ(values.hardeningLength, 6.0f);
  EXPECT_EQ(values.power, 4.0f);
}

TEST(TechniqueParameters, ReachTheMathematics) {
  Probe probe;
  probe.parameters = {{"curve", std::string("marmoset")}, {"hardeningLength", 2.5}, {"power", 3.0}};
  const auto shape = probeShape(probeGeometry(probe, glm::dvec3(0.0)), 6.0f, 0.5f);
  EXPECT_EQ(shape.parameters.curve, 4);
  EXPECT_EQ(shape.parameters.hardeningLength, 2.5f);
  EXPECT_EQ(shape.parameters.power, 3.0f);
}

TEST(TechniqueParameters, SetAndReadBackAndTheDefaultIsNotKept) {
  for (const ParameterRow& row : parameterRows()) {
    Probe probe;
    EXPECT_EQ(parameterNumber(probe, row), row.standard) << row.name;
    const double other = row.kind == ParameterKind::Choice || row.kind == ParameterKind::Switch
                             ? (row.standard == 0.0 ? 1.0 : 0.0)
                             : row.max;
    setParameter(probe, row, other);
    EXPECT_EQ(parameterProblem(std::string(row.name), probe.parameters.at(std::string(row.name))), "") << row.name;
    EXPECT_EQ(parameterNumber(probe, row), other) << row.name;
    setParameter(probe, row, row.standard);
    EXPECT_TRUE(probe.parameters.empty()) << row.name;
  }
}

}  // namespace
}  // namespace boxprobe
