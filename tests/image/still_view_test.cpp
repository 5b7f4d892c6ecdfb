// While a view rests, what nothing shows of is not drawn again; whatever could make it show draws it at once. Pictures
// are compared byte for byte with those of a renderer that leaves nothing out.
#include <gtest/gtest.h>

#include <map>

#include "data/scenes/glb_writer.h"
#include "data/scenes/scenes.h"
#include "filters/core/scene/changes.h"
#include "filters/io/gltf/model_file.h"
#include "filters/vtk/frame/frame_report.h"
#include "filters/vtk/scene/vtkCulledRenderer.h"
#include "tests/support/scene_picture.h"
#include "tests/unit/temporary_folder.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 320, kHeight = 180;

class StillViewTest : public TemporaryFolder {
 protected:
  void open(Scene scene, int samples = 0) {
    for (Probe& probe : scene.probes) {
      probe.faceSize = 32;
      probe.bounces = 1;
    }
    picture = std::make_unique<ScenePicture>(std::move(scene), kWidth, kHeight, samples);
    picture->show(cameraNamed(picture->scene, "main"));
  }
  void openFile(const std::string& name, int samples = 0) {
    open(ScenePicture::fromFile("scenes/" + name + ".boxprobe.json", 8, 8).scene, samples);
  }
  std::uint64_t leftOut() { return picture->renderer->counters().drawsCulled; }
  vtkCulledRenderer* renderer() { return vtkCulledRenderer::SafeDownCast(picture->renderer->renderer()); }
  /// The picture as it is, and that it is the one with everything drawn.
  ImageRgba8 checked(const std::string& what) {
    ImageRgba8 image = picture->display();
    const std::uint64_t out = leftOut();
    renderer()->SetHiddenCulling(false);
    const ImageRgba8 whole = picture->display();
    EXPECT_EQ(leftOut(), 0u);
    renderer()->SetHiddenCulling(true);
    EXPECT_TRUE(image.pixels == whole.pixels) << what << ", " << out << " left out";
    keepPicture(image, "still_" + what);
    return image;
  }
  /// Draws the view until it rests.
  std::uint64_t rest() {
    for (int i = 0; i < 4; ++i) picture->display();
    return leftOut();
  }

  std::unique_ptr<ScenePicture> picture;
};

TEST_F(StillViewTest, AClosedRoomIsDrawnWithoutItsSky) {
  for (const int samples : {0, 4}) {
    openFile("room", samples);
    // The first frame may still choose programs, and then the second counts as the first.
    const ImageRgba8 first = picture->display();
    EXPECT_EQ(leftOut(), 0u);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(first.pixels == picture->display().pixels) << "frame " << i + 2;
    EXPECT_GE(leftOut(), 1u);
    bool said = false;
    for (const std::string& line : english(skippedLines(picture->renderer->frameReport()))) {
      said = said || line.find("shows nowhere") != std::string::npos;
    }
    EXPECT_TRUE(said);
  }
}

TEST_F(StillViewTest, TheSkyIsDrawnAroundWhereItShows) {
  openFile("building", 4);
  rest();
  const OcclusionQuery::Rectangle shows = renderer()->GetBackdropRectangle();
  EXPECT_GT(shows.width, 0);
  EXPECT_LT(shows.height, kHeight * 3 / 4) << "it lies above the horizon";
  EXPECT_EQ(shows.y + shows.height, kHeight) << "and reaches the upper edge";
  checked("sky");
}

TEST_F(StillViewTest, EverySceneIsTheSameWithoutWhatIsHidden) {
  for (const char* name :
       {"room", "building", "gallery", "six-faces", "furnished", "glass", "mirror-hall", "windows"}) {
    openFile(name, 4);
    for (const Camera& camera : picture->scene.cameras) {
      picture->renderer->applyCamera(camera);
      picture->renderer->finishWork();
      const std::uint64_t out = rest();
      std::printf("  %-10s %-10s %d left out\n", name, camera.name.c_str(), static_cast<int>(out));
      checked(std::string(name) + "_" + camera.name);
    }
  }
}

TEST_F(StillViewTest, WhatComesIntoViewIsThereInThatFrame) {
  openFile("room");
  ASSERT_GE(rest(), 1u);
  Camera out = cameraNamed(picture->scene, "main");
  out.position = out.target + 20.0 * (out.position - out.target);
  out.position.y += 30.0;
  picture->renderer->applyCamera(out);
  picture->renderer->finishWork();
  const ImageRgba8 outside = picture->display();
  EXPECT_EQ(leftOut(), 0u);
  EXPECT_TRUE(outside.pixels == checked("moved").pixels);

  picture->renderer->applyCamera(cameraNamed(picture->scene, "main"));
  picture->renderer->finishWork();
  ASSERT_GE(rest(), 1u);
  const ImageRgba8 closed = picture->display();
  for (const Instance& instance : loadModelFile(picture->scene.models[0].file).instances) {
    if (instance.node == "floor" || instance.node.find("sphere") == 0) continue;
    picture->scene.objects[instance.node].visible = false;
  }
  Changes changes;
  changes.objects = true;
  picture->renderer->sync(picture->scene, changes);
  picture->renderer->finishWork();
  const ImageRgba8 open = picture->display();
  EXPECT_EQ(leftOut(), 0u) << "walls hidden";
  EXPECT_FALSE(open.pixels == closed.pixels);
  EXPECT_TRUE(open.pixels == checked("walls_hidden").pixels);
}

TEST_F(StillViewTest, AMaterialThatIsEditedHidesNothingMore) {
  openFile("room");
  ASSERT_GE(rest(), 1u);
  const ImageRgba8 closed = picture->display();
  for (const Material& material : loadModelFile(picture->scene.models[0].file).materials) {
    MaterialOverride& edited = picture->scene.materials[material.name];
    edited.metallic = 0.0f;
    edited.transmission = 1.0f;
  }
  Changes changes;
  changes.materials = true;
  picture->renderer->sync(picture->scene, changes);
  picture->renderer->finishWork();
  const ImageRgba8 glass = picture->display();
  EXPECT_FALSE(glass.pixels == closed.pixels);
  EXPECT_TRUE(glass.pixels == checked("glass").pixels);
}

TEST_F(StillViewTest, DraggingAProbeLeavesItHidden) {
  openFile("room");
  const std::uint64_t hidden = rest();
  ASSERT_GE(hidden, 1u);
  picture->renderer->setInteractive(true);
  for (int i = 0; i < 6; ++i) {
    picture->scene.probes[0].box.max.x -= 0.05;
    Changes changes;
    changes.probeShape = true;
    picture->renderer->sync(picture->scene, changes);
    picture->display();
    // The programs of a drag are others than those at rest: they begin anew.
    if (i > 2) {
      EXPECT_EQ(leftOut(), hidden) << "nothing but the light has changed";
    }
  }
  picture->renderer->setInteractive(false);
  checked("dragged");
}

TEST_F(StillViewTest, ManyObjectsLikewise) {
  scenes::Apartments made = scenes::apartments(16, 1);
  write("apartments.glb", scenes::glbBytes(made.model));
  made.scene.models = {{file("apartments.glb")}};
  open(made.scene, 4);
  picture->display();
  ASSERT_GT(renderer()->GetDrawn().size(), 0u) << "not many";
  std::printf("  %d left out of %d\n", static_cast<int>(rest()), static_cast<int>(renderer()->GetDrawn().size()));
  EXPECT_GE(leftOut(), 1u) << "the sky at least";
  const ImageRgba8 main = checked("many");
  const Camera other = cameraNamed(picture->scene, "corridor");
  picture->renderer->applyCamera(other);
  picture->renderer->finishWork();
  EXPECT_FALSE(checked("many_moved").pixels == main.pixels);
  rest();
  checked("many_moved_at_rest");
}

// An object is hidden if no pixel of a box about it shows. The box is a little larger than the object, in any unit, or
// flat objects would hide themselves.
TEST_F(StillViewTest, AsManyAreLeftOutInEveryUnit) {
  std::map<std::string, std::uint64_t> left;
  for (const double unit : {1.0, 1000.0, 0.001}) {
    scenes::Apartments made = scenes::apartments(2, 1);
    for (Mesh& mesh : made.model.meshes) {
      for (glm::vec3& position : mesh.positions) position *= static_cast<float>(unit);
    }
    for (Instance& instance : made.model.instances) instance.worldFromModel[3] *= glm::dvec4(glm::dvec3(unit), 1.0);
    write("apartments.glb", scenes::glbBytes(made.model));
    made.scene.models = {{file("apartments.glb")}};
    for (Probe& probe : made.scene.probes) {
      probe.box = {unit * probe.box.min, unit * probe.box.max};
      probe.origin *= unit;
      probe.influence.reset();
    }
    for (Camera& camera : made.scene.cameras) {
      camera.position *= unit;
      camera.target *= unit;
    }
    open(made.scene, 4);
    for (const Camera& camera : made.scene.cameras) {
      picture->renderer->applyCamera(camera);
      picture->renderer->finishWork();
      const std::uint64_t out = rest();
      std::printf("  %g: %s %d\n", unit, camera.name.c_str(), static_cast<int>(out));
      EXPECT_GE(out, 1u) << unit << " " << camera.name;
      EXPECT_EQ(left.try_emplace(camera.name, out).first->second, out) << unit << " " << camera.name;
      checked("unit_" + std::to_string(static_cast<int>(1.0 / unit)) + "_" + camera.name);
    }
  }
}

}  // namespace
