// Planes of planar mirrors: found, or refused with their place.
#include <gtest/gtest.h>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>

#include "filters/core/base/field_error.h"
#include "filters/core/geometry/mirror_plane.h"
#include "filters/core/geometry/mirror_view.h"
#include "tests/unit/error_text.h"

namespace boxprobe {
namespace {

/// A node "pane" of two triangles: corner, and what stands off the plane at the last corner.
std::vector<std::shared_ptr<const Model>> pane(float off, bool turned = false) {
  auto model = std::make_shared<Model>();
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, off}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  if (turned) mesh.indices = {0, 1, 2, 0, 3, 2};
  model->meshes.push_back(mesh);
  glm::dmat4 at(1.0);
  at[3] = glm::dvec4(1.0e6, 5.0, -2.0, 1.0);
  model->instances.push_back({"pane", 0, at});
  return {model};
}

Scene paneScene() {
  Scene scene;
  scene.models.push_back({"pane.glb"});
  scene.mirrors["pane"] = {};
  return scene;
}

TEST(MirrorPlane, IsFoundWithItsRectangle) {
  Scene scene = paneScene();
  const auto plane = mirrorPlane(scene, pane(0.0f), "pane");
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->normal, glm::dvec3(0, 0, 1));
  EXPECT_FALSE(plane->bothSides);
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& corner : plane->corners) middle += 0.25 * corner;
  EXPECT_NEAR(glm::distance(middle, glm::dvec3(1.0e6 + 1.5, 6.0, -2.0)), 0.0, 1.0e-9);
  EXPECT_NEAR(glm::distance(plane->corners[0], plane->corners[1]) * glm::distance(plane->corners[1], plane->corners[2]),
              6.0, 1.0e-9);
  // The override moves it: turned about its node's origin, then moved.
  scene.objects["pane"].rotationDegrees = {0, 90, 0};
  scene.objects["pane"].translation = {0, 1, 0};
  const auto moved = mirrorPlane(scene, pane(0.0f), "pane");
  EXPECT_NEAR(glm::distance(moved->normal, glm::dvec3(1, 0, 0)), 0.0, 1.0e-12);
  EXPECT_NEAR(glm::distance(moved->center, glm::dvec3(1.0e6, 7.0, -3.5)), 0.0, 1.0e-9);
}

// The middle of a tilted triangle's bounds is not in its plane.
TEST(MirrorPlane, OfATiltedTriangleIsItsOwn) {
  auto model = std::make_shared<Model>();
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 1}, {0, 1, 1}};
  mesh.indices = {0, 1, 2};
  model->meshes.push_back(mesh);
  model->instances.push_back({"pane", 0, glm::dmat4(1.0)});
  const auto plane = mirrorPlane(paneScene(), {model}, "pane");
  ASSERT_TRUE(plane);
  EXPECT_NEAR(glm::distance(plane->normal, glm::normalize(glm::dvec3(-1, -1, 1))), 0.0, 1e-12);
  for (const glm::vec3& p : mesh.positions) {
    EXPECT_NEAR(glm::dot(glm::dvec3(p) - plane->center, plane->normal), 0.0, 1e-12);
  }
  for (const glm::dvec3& corner : plane->corners) EXPECT_NEAR(glm::dot(corner, plane->normal), 0.0, 1e-12);
}

TEST(MirrorPlane, WhatIsNotFlatIsRefusedByName) {
  const Scene scene = paneScene();
  EXPECT_NO_THROW(checkMirrors(scene, pane(1.0e-4f)));
  const std::string bent = errorText([&] { checkMirrors(scene, pane(0.01f)); });
  EXPECT_EQ(bent.rfind("mirrors.pane: is not planar", 0), 0u) << bent;
  const std::string both = errorText([&] { checkMirrors(scene, pane(0.0f, true)); });
  EXPECT_NE(both.find("mirrors.pane"), std::string::npos) << both;
  EXPECT_FALSE(mirrorPlane(scene, pane(0.0f), "else"));
}

/// A floor of 4 x 4 around the world's origin, seen from above, far from it all.
struct FloorView {
  MirrorPlane plane;
  PictureView view;
  explicit FloorView(bool parallel) {
    const glm::dvec3 at(1.0e6, 2.0, -3.0e5);
    plane.center = at;
    plane.normal = {0, 1, 0};
    plane.corners = {at + glm::dvec3(-2, 0, 2), at + glm::dvec3(2, 0, 2), at + glm::dvec3(2, 0, -2),
                     at + glm::dvec3(-2, 0, -2)};
    view.eye = at + glm::dvec3(0.5, 1.5, 3.0);
    view.forward = glm::normalize(glm::dvec3(-0.2, -0.6, -1.0));
    view.parallel = parallel;
    view.width = 640;
    view.height = 480;
    view.clipFromView =
        parallel ? glm::ortho(-2.0, 2.0, -1.5, 1.5, 0.1, 20.0) : glm::perspective(1.0, 640.0 / 480.0, 0.1, 20.0);
  }
};

TEST(MirrorView, SeesWhatTheMirrorShowsAtItsPixelAndNothingBehindIt) {
  for (const bool parallel : {false, true}) {
    const FloorView f(parallel);
    const std::vector<glm::dvec2> part = visiblePart(f.plane, f.view);
    ASSERT_GE(part.size(), 3u);
    EXPECT_GT(areaOf(part, f.view), 0.0);
    EXPECT_LT(areaOf(part, f.view), 640.0 * 480.0);
    const MirrorRect rect = mirroredRect(part, f.view, 0.0);
    EXPECT_EQ(rect.width % kRectGrid, 0);
    const PictureView mirrored = mirroredView(f.plane, f.view, rect, 30.0);
    const auto clipOf = [](const PictureView& view, const glm::dvec3& p) {
      return view.clipFromView * view.viewFromEye() * glm::dvec4(p - view.eye, 1.0);
    };
    for (const glm::dvec3& offset : {glm::dvec3(0.3, 0, 0.4), glm::dvec3(-0.6, 0, -0.2), glm::dvec3(0.1, 0, -0.9)}) {
      const glm::dvec3 p = f.plane.center + offset;
      const glm::dvec4 direct = clipOf(f.view, p), seen = clipOf(mirrored, p);
      // On the mirror itself: the same pixel, left and right exchanged, and the nearest depth there is.
      const glm::dvec2 pixel(0.5 * (1.0 - direct.x / direct.w) * 640.0, 0.5 * (1.0 + direct.y / direct.w) * 480.0);
      const glm::dvec2 inRect(rect.x + 0.5 * (1.0 + seen.x / seen.w) * rect.width,
                              rect.y + 0.5 * (1.0 + seen.y / seen.w) * rect.height);
      EXPECT_NEAR(glm::distance(pixel, inRect), 0.0, 1.0e-6);
      EXPECT_NEAR(seen.z / seen.w, -1.0, 1.0e-9);
      // What the reflected ray meets is seen at the same pixel; depth grows along it; below the floor all is cut.
      const glm::dvec3 in = parallel ? f.view.forward : glm::normalize(p - f.view.eye);
      const glm::dvec3 reflected = in - 2.0 * glm::dot(in, f.plane.normal) * f.plane.normal;
      double before = -1.0;
      for (const double t : {0.5, 2.0, 6.0}) {
        const glm::dvec4 met = clipOf(mirrored, p + t * reflected);
        EXPECT_NEAR(met.x / met.w, seen.x / seen.w, 1.0e-8);
        EXPECT_NEAR(met.y / met.w, seen.y / seen.w, 1.0e-8);
        EXPECT_GT(met.z / met.w, before);
        EXPECT_LT(met.z / met.w, 1.0);
        before = met.z / met.w;
      }
      const glm::dvec4 below = clipOf(mirrored, p - 0.2 * reflected);
      EXPECT_LT(below.z, -below.w);
    }
  }
}

TEST(MirrorView, KnowsWhenAMirrorCannotBeSeen) {
  FloorView f(false);
  EXPECT_TRUE(facesEye(f.plane, f.view));
  f.view.forward = {0.0, 0.8, 0.6};  // away from it, half of it behind the eye
  EXPECT_TRUE(visiblePart(f.plane, f.view).empty());
  f.view.eye.y -= 3.0;
  EXPECT_FALSE(facesEye(f.plane, f.view));
  f.plane.bothSides = true;
  EXPECT_TRUE(facesEye(f.plane, f.view));
  EXPECT_EQ(f.plane.normal, glm::dvec3(0, -1, 0));
  // Standing on it: clipped before the eye, it still covers the lower half of the picture.
  FloorView on(false);
  on.view.eye = on.plane.center + glm::dvec3(0.0, 0.5, 0.0);
  on.view.forward = {0.0, 0.0, -1.0};
  const double area = areaOf(visiblePart(on.plane, on.view), on.view);
  EXPECT_GT(area, 0.2 * 640.0 * 480.0);
  EXPECT_LT(area, 0.5 * 640.0 * 480.0);
}

}  // namespace
}  // namespace boxprobe
