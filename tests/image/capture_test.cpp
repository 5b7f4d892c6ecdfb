// What a probe holds after a capture: coverage, range, levels, bounces; and what is captured again after which edit.
#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkRenderer.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "filters/math/cube/spherical_harmonics.h"
#include "filters/math/shared/shared_math.h"
#include "filters/vtk/capture/prefilter.h"
#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/gl/software_driver.h"
#include "filters/vtk/gl/texture_memory.h"
#include "filters/vtk/surface/vtkProbeActor.h"
#include "tests/support/gpu_window.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

/// A source cube map to be written by the test, and room for what is filtered from it.
class PrefilterTest : public ::testing::Test {
 protected:
  PrefilterTest() {
    source.allocate(kFace, 7, GL_RGBA16F);
    chain.allocate(kFace, prefilterLevels(kFace), GL_RGBA16F);
  }
  static constexpr int kFace = 64;
  vtkSmartPointer<vtkOpenGLRenderWindow> window = makeWindow();
  Counters counters;
  Prefilter prefilter{window, &counters};
  CubeTexture source, chain;
};

// Mesa 25 says that llvmpipe had some 30 MB left.
TEST_F(PrefilterTest, ASoftwareRendererHasTheMachinesMemory) {
  if (!drawsOnCpu()) GTEST_SKIP() << "drawn by a graphics card";
  const auto bytes =
      static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) / 2 * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  // A virtual machine's memory may change between the two questions.
  EXPECT_NEAR(static_cast<double>(textureMemoryLimit()), static_cast<double>(bytes), 0.01 * static_cast<double>(bytes));
}

TEST_F(PrefilterTest, WhiteFurnaceStaysWhiteAtEveryLevel) {
  const std::vector<float> white(std::size_t{kFace} * kFace * 4, 1.0f);
  for (int face = 0; face < 6; ++face) source.writeFace(face, 0, white);
  prefilter.begin(source, chain);
  for (int level = 1; level < chain.levels(); ++level) prefilter.filterLevel(source, chain, level);
  for (int level = 0; level < chain.levels(); ++level) {
    for (int face = 0; face < 6; ++face) {
      for (const float value : chain.readFace(face, level)) ASSERT_NEAR(value, 1.0f, 1e-3f) << "level " << level;
    }
  }
  const ShCoefficients sh = Prefilter::irradiance(source);
  for (const glm::vec3 n : {glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::normalize(glm::vec3(1, 2, -3))}) {
    const glm::vec3 e = shading::shIrradiance(n, sh[0], sh[1], sh[2], sh[3], sh[4], sh[5], sh[6], sh[7], sh[8]);
    EXPECT_NEAR(e.x, 1.0f, 1e-3f);
  }
  EXPECT_EQ(counters.levelsFiltered, static_cast<std::uint64_t>(chain.levels() - 1));
}

// A cosine lobe has a closed form: radiance max(d.y, 0) gives irradiance over pi of 2/3 for a normal up, by quadrature
// independent of the code under test.
TEST_F(PrefilterTest, IrradianceOfACosineSky) {
  for (int face = 0; face < 6; ++face) {
    std::vector<float> texels;
    for (int row = 0; row < kFace; ++row) {
      for (int column = 0; column < kFace; ++column) {
        const glm::vec3 d =
            glm::normalize(shading::cubeDirection(face, 2.0f * (static_cast<float>(column) + 0.5f) / kFace - 1.0f,
                                                  2.0f * (static_cast<float>(row) + 0.5f) / kFace - 1.0f));
        texels.insert(texels.end(), {std::max(d.y, 0.0f), 0.0f, 0.0f, 1.0f});
      }
    }
    source.writeFace(face, 0, texels);
  }
  prefilter.begin(source, chain);
  const ShCoefficients sh = Prefilter::irradiance(source);
  const auto at = [&](const glm::vec3& n) {
    return shading::shIrradiance(n, sh[0], sh[1], sh[2], sh[3], sh[4], sh[5], sh[6], sh[7], sh[8]).x;
  };
  // Bands above 2 are left out, so a few percent are expected.
  EXPECT_NEAR(at({0, 1, 0}), 2.0 / 3.0, 0.02);
  EXPECT_NEAR(at({1, 0, 0}), 2.0 / (3.0 * 3.14159265), 0.02);  // integral of max(y,0) max(x,0) / pi
  EXPECT_NEAR(at({0, -1, 0}), 0.0, 0.03);
}

TEST(Levels, BakeAndLookupAreInverse) {
  for (int last = 1; last <= 10; ++last) {
    for (int level = 0; level <= last; ++level) {
      const float p = shading::roughnessForLevel(static_cast<float>(level), static_cast<float>(last));
      EXPECT_NEAR(shading::levelForRoughness(p, static_cast<float>(last)), level, 2e-5f * static_cast<float>(last));
    }
    EXPECT_EQ(shading::roughnessForLevel(0.0f, static_cast<float>(last)), 0.0f);
    EXPECT_EQ(shading::roughnessForLevel(static_cast<float>(last), static_cast<float>(last)), 1.0f);
  }
}

TEST(Capture, OnlyWhatAnEditNeedsIsMadeAgain) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  picture.scene.probes[0].bounces = 1;  // one capture an edit, until it has more
  const Camera camera = cameraNamed(picture.scene, "main");
  picture.show(camera);
  const auto captured = [&] { return picture.renderer->counters().facesCaptured; };
  const auto filtered = [&] { return picture.renderer->counters().levelsFiltered; };
  EXPECT_GE(captured(), 6u);
  std::uint64_t faces = captured(), levels = filtered();

  const auto edit = [&](const std::function<void(Scene&)>& change) {
    const Scene before = picture.scene;
    change(picture.scene);
    picture.renderer->sync(picture.scene, difference(before, picture.scene));
    picture.renderer->finishWork();
  };
  edit([](Scene& s) { s.probes[0].box.max.x += 0.5; });
  edit([](Scene& s) { s.probes[0].blendDistance.min.y = 0.7; });
  edit([](Scene& s) { s.probes[0].technique = "sphere"; });
  edit([](Scene& s) { s.materials["sphere"].roughness = 0.5f; });  // spheres are not seen by the probe
  EXPECT_EQ(captured(), faces);
  EXPECT_EQ(filtered(), levels + picture.renderer->counters().levelsMadeLater) << "of the capture that is there";

  edit([](Scene& s) { s.probes[0].rotationDegrees.y = 20.0; });  // the cube's axes turn with the box
  EXPECT_EQ(captured(), faces + 6);
  faces = captured();

  const glm::dvec3 origin = picture.scene.probes[0].origin;
  edit([](Scene& s) { s.probes[0].origin.x += 0.25; });
  EXPECT_EQ(captured(), faces + 6);
  faces = captured();
  levels = filtered();
  edit([&](Scene& s) { s.probes[0].origin = origin; });  // as by undo: the earlier maps are still there
  EXPECT_EQ(captured(), faces);
  EXPECT_EQ(filtered(), levels);

  edit([](Scene& s) { s.probes[0].bounces = 3; });
  EXPECT_EQ(captured(), faces + 12) << "the first bounce is there already";
  edit([](Scene& s) {
    s.probes.push_back(s.probes[0]);
    s.probes[1].name = "far away";
    s.probes[1].box = Box{{100, 0, 100}, {101, 1, 101}};
  });
  EXPECT_EQ(captured(), faces + 12) << "a probe whose influence meets no object is not captured";
}

// A probe whose influence is its box: dragging a face takes objects in and out of it, and its weights over others.
TEST(Capture, DraggingABoxOverObjectsCompilesNothing) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  picture.scene.probes[0].influence.reset();
  picture.renderer->setEditable(true);
  picture.show(cameraNamed(picture.scene, "main"));
  picture.display();
  const ImageRgba8 before = picture.display();
  const Counters counted = picture.renderer->counters();
  picture.renderer->setInteractive(true);
  for (int i = 1; i <= 8; ++i) {
    const Scene last = picture.scene;
    picture.scene.probes[0].box.max.x = 4.0 - i * 0.8;
    picture.renderer->sync(picture.scene, difference(last, picture.scene));
    EXPECT_FALSE(picture.renderer->workPending());
    picture.display();
  }
  EXPECT_NE(picture.display().pixels, before.pixels) << "the picture follows the drag";
  EXPECT_EQ(picture.renderer->counters().programsCompiled, counted.programsCompiled);
  EXPECT_EQ(picture.renderer->counters().facesCaptured, counted.facesCaptured);
  EXPECT_EQ(picture.renderer->counters().levelsFiltered, counted.levelsFiltered);
}

// What stands in a box is worked out for the box at rest, not for each on the way.
TEST(Capture, DraggingABoxLeavesTheImpostorsBlocks) {
  ScenePicture picture = ScenePicture::fromFile("scenes/furnished.boxprobe.json", 64, 36);
  picture.scene.probes[0].technique = "impostor";
  picture.scene.probes[0].faceSize = 64;
  picture.scene.probes[0].bounces = 1;
  picture.show(cameraNamed(picture.scene, "main"));
  picture.display();
  const auto latest = [&picture] {
    vtkActorCollection* actors = picture.renderer->renderer()->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor()) {
      auto* lit = vtkProbeActor::SafeDownCast(actor);
      if (lit == nullptr || lit->GetPass()->GetBinding() == nullptr) continue;
      if (lit->GetPass()->GetBinding()->probes.empty()) continue;
      const DrawnProbe& probe = *lit->GetPass()->GetBinding()->probes.front();
      return probe.maps->relief.blocks(probe.maps->distance, probe.geometry, true);
    }
    return std::shared_ptr<const ReliefBlocks>();
  };
  const auto before = latest();
  ASSERT_TRUE(before);
  EXPECT_GT(before->count, 0);
  picture.renderer->setInteractive(true);
  for (int i = 1; i <= 3; ++i) {
    const Scene last = picture.scene;
    picture.scene.probes[0].box.max.x -= 0.1;
    picture.renderer->sync(picture.scene, difference(last, picture.scene));
    picture.display();
    EXPECT_EQ(latest(), before);
  }
  picture.renderer->setInteractive(false);
  picture.renderer->finishWork();
  picture.display();
  EXPECT_NE(latest(), before);
}

// Blocks of distances are bounded when rays are first followed through them, once per capture; a drag does nothing of
// it.
TEST(Capture, DistancesAreBoundedWhenRaysAreFollowed) {
  ScenePicture picture = ScenePicture::fromFile("scenes/furnished.boxprobe.json", 64, 36);
  const auto bounded = [&picture] { return picture.renderer->counters().reliefsBounded; };
  const auto change = [&picture](const std::function<void(Probe&)>& edit) {
    const Scene last = picture.scene;
    edit(picture.scene.probes[0]);
    picture.renderer->sync(picture.scene, difference(last, picture.scene));
    picture.renderer->finishWork();
    return picture.display();
  };
  picture.scene.probes[0].technique = "impostor";
  picture.scene.probes[0].faceSize = 64;
  picture.scene.probes[0].bounces = 1;
  picture.show(cameraNamed(picture.scene, "main"));
  const auto refined = picture.display();
  EXPECT_EQ(bounded(), 0u) << "three steps need no blocks";
  const auto marched = change([](Probe& probe) { probe.parameters = {{"steps", 16.0}}; });
  EXPECT_EQ(bounded(), 1u);
  EXPECT_NE(marched.pixels, refined.pixels);
  const Counters counted = picture.renderer->counters();
  change([](Probe& probe) { probe.parameters = {{"steps", 24.0}}; });
  for (int i = 0; i < 3; ++i) change([](Probe& probe) { probe.box.max.x -= 0.1; });
  EXPECT_EQ(picture.renderer->counters().programsCompiled, counted.programsCompiled);
  EXPECT_EQ(picture.renderer->counters().facesCaptured, counted.facesCaptured);
  EXPECT_EQ(bounded(), 1u);
  change([](Probe& probe) { probe.origin.x += 0.3; });
  EXPECT_EQ(bounded(), 2u) << "another capture, other distances";
}

TEST(Capture, AnUndoBetweenBouncesBringsTheEarlierPictureBack) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  picture.scene.probes[0].bounces = 2;
  picture.show(cameraNamed(picture.scene, "main"));
  const ImageRgbaF before = picture.linear(1);
  const std::uint64_t faces = picture.renderer->counters().facesCaptured;
  const Scene kept = picture.scene;
  picture.scene.probes[0].origin = {-3.0, 0.5, 2.0};
  picture.renderer->sync(picture.scene, difference(kept, picture.scene));
  picture.window->MakeCurrent();
  while (picture.renderer->counters().facesCaptured < faces + 7) picture.renderer->step();
  EXPECT_NE(picture.linear(1).pixels, before.pixels) << "the first bounce is shown";
  picture.renderer->sync(kept, difference(picture.scene, kept));
  picture.renderer->finishWork();
  EXPECT_EQ(picture.linear(1).pixels, before.pixels);
}

TEST(Capture, AProbeThatCoversAnObjectButIsOneTooManyLeavesTheSky) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  picture.scene.sky = SkyColor{{0.0f, 2.0f, 0.0f}};
  for (const char* node : {"sphere 1", "sphere 2", "sphere 3"}) picture.scene.objects[node].visible = false;
  // Four more important ones touch all of the floor with weight 0: no cut leaves one of them out.
  for (int i = 0; i < 4; ++i) {
    Probe above = picture.scene.probes[0];
    above.name = "above " + std::to_string(i);
    above.importance = 2.0;
    above.influence->min.y = 0.0;
    above.influence->max.y = 0.3 + 0.1 * i;
    above.blendDistance = BlendDistance{glm::dvec3(0.0, 0.2, 0.0), glm::dvec3(0.0)};
    picture.scene.probes.push_back(above);
  }
  picture.show(cameraNamed(picture.scene, "B"));  // looks down at the floor
  const ImageRgbaF image = picture.linear(1);
  const float* middle = &image.pixels[(18 * 64 + 32) * 4];
  EXPECT_GT(middle[1], 1.0f);
}

TEST(Capture, ImportantProbesInACornerTakeNothingFromTheRestOfAnObject) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  picture.scene.sky = SkyColor{{0.0f, 2.0f, 0.0f}};
  for (const char* node : {"sphere 1", "sphere 2", "sphere 3"}) picture.scene.objects[node].visible = false;
  picture.show(cameraNamed(picture.scene, "B"));  // looks down at the floor's middle
  const ImageRgbaF alone = picture.linear(1);
  for (int i = 0; i < 4; ++i) {
    Probe small = picture.scene.probes[0];
    small.name = "small " + std::to_string(i);
    small.importance = 2.0;
    small.influence = Box{{3.9, 0.0, 0.5 * i}, {4.0, 0.1, 0.5 * i + 0.1}};
    picture.scene.probes.push_back(small);
  }
  picture.show(cameraNamed(picture.scene, "B"));
  const ImageRgbaF image = picture.linear(1);
  const std::size_t middle = 4 * (18 * 64 + 32);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(image.pixels[middle + c], alone.pixels[middle + c], 0.01f);
}

TEST(Capture, BrightTexelsAreClampedAndCounted) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  picture.scene.materials["lamp"].emissive = glm::vec3(1.0e6f);
  picture.show(cameraNamed(picture.scene, "main"));
  EXPECT_GT(picture.renderer->counters().texelsClamped, 0u);
  EXPECT_EQ(picture.renderer->counters().texelsNotFinite, 0u);
  for (const float value : picture.linear(1).pixels) ASSERT_TRUE(std::isfinite(value));
}

TEST(Capture, WithoutReflectiveObjectsNothingIsCaptured) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  for (const char* node : {"floor", "lamp", "sphere 1", "sphere 2", "sphere 3"})
    picture.scene.objects[node].visible = false;
  picture.show(cameraNamed(picture.scene, "main"));
  EXPECT_EQ(picture.renderer->counters().facesCaptured, 0u);
}

// The reflected colour on a sphere carried out of the probe's influence: continuous with a blend distance, a jump
// without.
TEST(Blend, FromProbeToSkyWithoutAJump) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 65, 65);
  picture.scene.sky = SkyColor{{0.0f, 0.0f, 3.0f}};
  picture.scene.probes[0].influence.reset();
  Camera camera;
  camera.verticalFovDegrees = 2.0;  // looks at one point of the floor
  const auto largestStep = [&](double blend) {
    picture.scene.probes[0].box.max.x = 1.0;
    picture.scene.probes[0].blendDistance = BlendDistance{glm::dvec3(0.0), glm::dvec3(blend, 0.0, 0.0)};
    picture.show(camera);
    double previous = -1.0, worst = 0.0;
    for (int i = 0; i <= 60; ++i) {
      const double x = -0.5 + 2.0 * i / 60.0;
      Camera eye = camera;
      eye.position = {x, 1.0, 2.5};
      eye.target = {x, 0.0, 2.501};
      eye.up = {0.0, 0.0, -1.0};
      picture.renderer->applyCamera(eye);
      const ImageRgbaF image = picture.linear(1);
      const double blue = image.pixels[(32 * 65 + 32) * 4 + 2];
      if (previous >= 0.0) worst = std::max(worst, std::abs(blue - previous));
      previous = blue;
    }
    return worst;
  };
  const double jump = largestStep(0.0), smooth = largestStep(1.0);
  EXPECT_GT(jump, 1.0);
  EXPECT_LT(smooth, 0.25 * jump);
}

}  // namespace
