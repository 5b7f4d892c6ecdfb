// Lines drawn nearer to the eye than they lie: where on the screen, and how far away.
#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <array>
#include <glm/geometric.hpp>

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

}  // namespace
}  // namespace boxprobe
