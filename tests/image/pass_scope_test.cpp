// A pass that fails leaves nothing behind: settings, cameras and the next picture are what they were.
#include "filters/vtk/draw/pass_scope.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "filters/core/base/errors.h"
#include "filters/vtk/capture/cube_capture.h"
#include "filters/vtk/gl/frame_target.h"
#include "tests/support/gpu_window.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

/// A draw state of a window whose frames are drawn with settings that are no defaults.
struct Shown {
  vtkSmartPointer<vtkOpenGLRenderWindow> window = makeWindow();
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkCamera> camera;
  std::shared_ptr<DrawState> state = std::make_shared<DrawState>();
  PassSettings before;

  Shown() {
    window->AddRenderer(renderer);
    camera->SetPosition(1.0, 2.0, 3.0);
    renderer->SetActiveCamera(camera);
    state->shown = renderer;
    state->setExposure(2.0f);
    state->setDragging(true);
    state->setDebugView({3, 0.25f, 4.0f});
    before = state->pass();
  }

  void expectUntouched() const {
    EXPECT_TRUE(state->pass() == before);
    EXPECT_EQ(renderer->GetActiveCamera(), camera.Get());
    EXPECT_EQ(glm::dvec3(camera->GetPosition()[0], camera->GetPosition()[1], camera->GetPosition()[2]),
              glm::dvec3(1.0, 2.0, 3.0));
  }
};

void changeAll(PassSettings& pass) {
  pass.exposure = kLinearOutput;
  pass.dragging = false;
  pass.debug = {};
  pass.firstBounce = true;
  pass.movingShadowsOn = pass.countDraws = false;
  pass.frame = 7;
  pass.pixelOrigin = {8, 9};
  pass.heightPlaneView = {1.0f, 2.0f, 3.0f, 4.0f};
}

TEST(PassScope, EverySettingIsPutBackAlsoWhenThePassThrows) {
  const Shown shown;
  EXPECT_THROW(
      {
        const PassScope outer(*shown.state, [](PassSettings& pass) { pass.exposure = kLinearOutput; });
        const PassSettings linear = shown.state->pass();
        {
          const PassScope inner(*shown.state, changeAll);
          EXPECT_EQ(shown.state->pass().frame, 7);
          EXPECT_FALSE(shown.state->pass() == linear);
        }
        EXPECT_TRUE(shown.state->pass() == linear);
        const PassScope again(*shown.state, changeAll);
        throw WorkError("the driver refuses");
      },
      WorkError);
  shown.expectUntouched();
}

TEST(PassScope, CamerasArePutBackAndTheWindowsIsLitAnew) {
  const Shown shown;
  vtkNew<vtkRenderer> own;
  vtkNew<vtkCamera> earlier, passes;
  for (vtkCamera* had : {static_cast<vtkCamera*>(nullptr), earlier.Get()}) {
    own->SetActiveCamera(had);
    const vtkMTimeType windows = shown.camera->GetMTime(), of = passes->GetMTime();
    EXPECT_THROW(
        {
          const PassScope scope(*shown.state, own, passes, changeAll);
          EXPECT_EQ(own->GetActiveCamera(), passes.Get());
          EXPECT_GT(passes->GetMTime(), of);
          throw WorkError("the driver refuses");
        },
        WorkError);
    EXPECT_EQ(own->IsActiveCameraCreated() != 0 ? own->GetActiveCamera() : nullptr, had);
    EXPECT_GT(shown.camera->GetMTime(), windows) << "its lights are uploaded for it again";
    shown.expectUntouched();
  }
}

// A face of so many samples that no driver has room for it: refused before anything is drawn.
TEST(PassScope, ACaptureThatTheDriverRefusesLeavesTheDebugViewOn) {
  const Shown shown;
  CubeCapture capture(shown.window, shown.state);
  CubeTexture radiance;
  radiance.allocate(4, 1, GL_RGBA16F);
  CaptureSettings settings;
  settings.samplesPerTexelSide = 1 << 20;
  EXPECT_THROW(capture.captureFace(settings, 0, {}, {}, radiance, nullptr), InputError);
  shown.expectUntouched();
  capture.release();
}

TEST(PassScope, AnExplanationThatTheDriverRefusesLeavesThePictureAsItWas) {
  ScenePicture picture = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  picture.show(cameraNamed(picture.scene, "main"));
  SurfaceViewSettings view;
  view.view = *findSurfaceView("level");
  picture.renderer->setView(view);
  const ImageRgba8 before = picture.display();
  const auto draws = picture.renderer->counters().drawsByProbeCount;
  // Wider than any texture.
  EXPECT_THROW(picture.renderer->explain({{0, 0}, {1, 0}}, 1 << 20, 1), WorkError);
  EXPECT_EQ(picture.display().pixels, before.pixels);
  EXPECT_EQ(picture.renderer->counters().drawsByProbeCount, draws);
}

TEST(PassScope, ALinearPictureThatIsStoppedLeavesThePictureAsItWas) {
  ScenePicture picture = ScenePicture::fromFile("scenes/mirror-hall.boxprobe.json", 64, 36);
  picture.scene.probes[0].faceSize = 32;
  picture.scene.probes[0].bounces = 1;
  picture.scene.probes[0].technique = "box+raytraced";
  picture.scene.probes[0].parameters["animated"] = true;
  picture.renderer->setFrameLimit(2);
  picture.show(cameraNamed(picture.scene, "main"));
  const auto whole = [&] {
    picture.renderer->restartPicture();
    picture.display();
    return picture.display();
  };
  const ImageRgba8 before = whole();
  const auto stop = [](int frame) {
    if (frame == 1) throw WorkError("stopped");
  };
  EXPECT_THROW(picture.renderer->renderLinear(64, 36, 1, 3, stop), WorkError);
  EXPECT_EQ(whole().pixels, before.pixels);
}

TEST(Framebuffers, OneThatWasRefusedIsRefusedAgain) {
  const auto window = makeWindow();
  FloatTarget target;
  FrameTarget frame;
  for (int attempt = 0; attempt < 2; ++attempt) {
    EXPECT_THROW(target.allocate(1 << 20, 1), WorkError);
    EXPECT_THROW(frame.allocate(1 << 20, 1, 0, 1), WorkError);
    EXPECT_EQ(target.framebuffer(), 0u);
    EXPECT_EQ(frame.framebuffer(), 0u);
  }
  target.allocate(4, 4);
  EXPECT_NE(target.framebuffer(), 0u);
}

}  // namespace
