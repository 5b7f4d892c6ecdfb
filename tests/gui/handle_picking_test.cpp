// Pixels and rays belong together, and the nearest handle is the one taken.
#include "filters/vtk/widgets/handle_picking.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <glm/geometric.hpp>
#include <random>

namespace boxprobe {
namespace {

class HandlePicking : public ::testing::Test {
 protected:
  void SetUp() override {
    camera_->SetPosition(1e6 + 3.0, 2.0, 7.0);
    camera_->SetFocalPoint(1e6, 1.0, 0.0);
    camera_->SetViewUp(0.1, 1.0, 0.0);
    camera_->SetViewAngle(50.0);
  }
  static constexpr double kWidth = 900.0, kHeight = 600.0;
  vtkNew<vtkCamera> camera_;
};

TEST_F(HandlePicking, PixelsAreWhereVtkDrawsThem) {
  const ViewProjection view(camera_, kWidth, kHeight);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> metres(-2.0, 2.0);
  vtkMatrix4x4* matrix = camera_->GetCompositeProjectionTransformMatrix(kWidth / kHeight, -1.0, 1.0);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 p(1e6 + metres(random), metres(random), metres(random));
    const double world[4] = {p.x, p.y, p.z, 1.0};
    double clip[4];
    matrix->MultiplyPoint(world, clip);
    const auto pixel = view.pixel(p);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x, 0.5 * kWidth * (1.0 + clip[0] / clip[3]), 1e-4);
    EXPECT_NEAR(pixel->y, 0.5 * kHeight * (1.0 - clip[1] / clip[3]), 1e-4);
    const Ray ray = view.ray(*pixel);
    const glm::dvec3 arm = p - ray.origin;
    EXPECT_NEAR(glm::length(glm::cross(arm, ray.direction)), 0.0, 1e-6);
  }
}

TEST_F(HandlePicking, NothingBehindTheViewer) {
  const ViewProjection view(camera_, kWidth, kHeight);
  EXPECT_FALSE(view.pixel(view.eyeWorld() - view.axes().forward));
}

TEST_F(HandlePicking, TheNearestHandleWithinReach) {
  const ViewProjection view(camera_, kWidth, kHeight);
  Probe one, two;
  one.origin = {1e6, 1.0, 0.0};
  one.box = {one.origin - 1.0, one.origin + 1.0};
  two = one;
  two.name = "two";
  two.origin.x += 0.5;
  const std::vector<Probe> probes = {one, two};
  const auto at = [&](const glm::dvec3& p) { return handleAt(probes, 0, view, *view.pixel(p), 10.0); };
  EXPECT_EQ(at(two.origin), (Handle{HandleKind::Origin, 1, {}}));
  for (const BoxFace& face : kBoxFaces) EXPECT_EQ(at(faceCenterWorld(one, face)), (Handle{HandleKind::Face, 0, face}));
  EXPECT_FALSE(handleAt(probes, 0, view, {5.0, 5.0}, 10.0));
  EXPECT_FALSE(handleAt(probes, std::nullopt, view, *view.pixel(faceCenterWorld(one, {0, false})), 5.0))
      << "only the selected probe's faces can be taken hold of";
}

TEST_F(HandlePicking, OfTwoAtOnePixelTheCloserOne) {
  const ViewProjection view(camera_, kWidth, kHeight);
  Probe far, near;
  far.origin = {1e6, 1.0, 0.0};
  near.origin = 0.5 * (far.origin + view.eyeWorld());
  near.name = "near";
  const auto taken = handleAt({far, near}, std::nullopt, view, *view.pixel(far.origin), 10.0);
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->probe, 1u);
}

}  // namespace
}  // namespace boxprobe
