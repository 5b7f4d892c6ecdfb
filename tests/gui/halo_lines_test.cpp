// Lines drawn nearer to the eye than they lie: where on the screen, and how far away.
#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "filters/vtk/widgets/wire_actors.h"

namespace boxprobe {
namespace {

using Homogeneous = std::array<double, 4>;

Homogeneous placed(vtkActor* actor, vtkIdType i) {
  double p[3];
  vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput()->GetPoint(i, p);
  const double in[4] = {p[0], p[1], p[2], 1.0};
  Homogeneous out;
  actor->GetUserMatrix()->MultiplyPoint(in, out.data());
  return out;
}

TEST(HaloLinesTest, APullMovesEachPointAlongItsRayFromTheEye) {
  const std::vector<glm::dvec3> points = {
      {1003.5, -2.25, 7.125}, {1001.25, 4.5, -3.75}, {998.5, 0.625, 2.5}, {1003.5, -2.25, 7.125}};
  const glm::dvec3 eye(1006.0, 1.75, 11.5);
  vtkNew<vtkRenderer> renderer;
  HaloLines lines(renderer, {{}, 1.5, 1.0, true});
  lines.setSegments(points);
  for (const double pull : {1.0, 0.875}) {
    lines.pullTowards(eye, pull);
    vtkActorCollection* actors = renderer->GetActors();
    ASSERT_EQ(actors->GetNumberOfItems(), 2);
    std::vector<double> factors;
    for (int a = 0; a < 2; ++a) {
      auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(a));
      for (vtkIdType i = 0; i < 4; ++i) {
        const Homogeneous p = placed(actor, i);
        EXPECT_DOUBLE_EQ(p[3], 1.0);
        const glm::dvec3 ray = points[static_cast<std::size_t>(i)] - eye;
        const glm::dvec3 offset = glm::dvec3(p[0], p[1], p[2]) - eye;
        const double factor = glm::dot(offset, ray) / glm::dot(ray, ray);
        EXPECT_LT(glm::length(offset - factor * ray), 1e-5) << "off its place on the screen";
        if (i == 0) factors.push_back(factor);
        EXPECT_NEAR(factor, factors.back(), 1e-6);
      }
    }
    EXPECT_NEAR(std::min(factors[0], factors[1]), pull, 1e-6) << "the line";
    EXPECT_GT(std::max(factors[0], factors[1]), 1.001 * pull) << "its halo lies behind";
  }
}

TEST(WireActorsTest, ADropEndsInACrossOnTheFloor) {
  const glm::dvec3 origin(2.25, 3.5, -1.75), foot(2.25, 0.5, -1.75);
  vtkNew<vtkRenderer> renderer;
  WireActors wires(renderer, false);
  wires.setDrop(std::array<glm::dvec3, 2>{origin, foot});
  wires.pullTowards(glm::dvec3(9.0, 2.0, 30.0), 1.0);
  int lines = 0;
  vtkActorCollection* actors = renderer->GetActors();
  for (int a = 0; a < actors->GetNumberOfItems(); ++a) {
    auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(a));
    vtkPolyData* data = vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput();
    if (data == nullptr || data->GetNumberOfPoints() == 0) continue;
    double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9};
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
      const Homogeneous p = placed(actor, i);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], p[axis]);
        high[axis] = std::max(high[axis], p[axis]);
      }
    }
    if (std::abs(high[1] - origin.y) > 1e-4) continue;  // the halo, behind the line
    ++lines;
    // Its arms are a twelfth of the height or so, along both axes of the floor.
    for (const int axis : {0, 2}) {
      EXPECT_NEAR(high[axis] + low[axis], 2.0 * foot[axis], 1e-4) << axis;
      EXPECT_NEAR(high[axis] - low[axis], 2.0 * 0.08 * 3.0, 1e-4) << axis;
    }
    EXPECT_NEAR(low[1], foot.y, 1e-4);
  }
  EXPECT_EQ(lines, 1);
}

}  // namespace
}  // namespace boxprobe
