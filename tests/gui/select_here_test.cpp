// The probe of a place: selected by a double click on what it lights, and by standing in it.
#include <gtest/gtest.h>

#include <QStatusBar>

#include "app/gui/handles/probe_widget.h"
#include "app/gui/view/viewport.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/gui/window_test.h"

namespace boxprobe {
namespace {

class SelectHereTest : public WindowTest {
 protected:
  // Three side by side along x; the camera looks down into the middle one.
  LoadedScene scene() const override {
    LoadedScene loaded = smallBuilding();
    const Probe first = loaded.scene.probes.front();
    loaded.scene.probes.clear();
    for (int i = 0; i < 3; ++i) {
      Probe probe = first;
      probe.name = std::string(1, static_cast<char>('a' + i));
      const double from = -3.0 + 2.0 * i;
      probe.box = {glm::dvec3(from, 0.0, -4.0), glm::dvec3(from + 2.0, 4.0, 4.0)};
      probe.origin = {from + 1.0, 2.9, -3.0};
      probe.blendDistance = {glm::dvec3(0.1), glm::dvec3(0.1)};
      loaded.scene.probes.push_back(probe);
    }
    Camera& camera = loaded.scene.cameras.front();
    camera.position = {2.0, 1.6, 1.5};
    camera.target = {2.0, 0.0, -1.0};
    return loaded;
  }
  std::string selected() {
    const auto index = document().selectedProbe();
    return index ? document().scene().probes[*index].name : std::string();
  }
  void stand(const glm::dvec3& at) {
    Camera camera = document().scene().cameras.front();
    camera.position = at;
    camera.target = at + glm::dvec3(0.0, -0.1, -1.0);
    const_cast<SceneRenderer&>(window_->renderer()).applyCamera(camera);
    emit window_->viewport().cameraMoved();
    waitUntilIdle();
  }
};

TEST_F(SelectHereTest, AnOpenedSceneSelectsTheProbeThatOneStandsIn) {
  EXPECT_EQ(selected(), "c");
}

TEST_F(SelectHereTest, AKeySelectsWhereTheCameraStands) {
  window_->viewport().setFocus();
  stand({-2.0, 1.6, 1.0});
  key(Qt::Key_P, Qt::ShiftModifier);
  EXPECT_EQ(selected(), "a");
  EXPECT_EQ(window_->statusBar()->currentMessage(), "Probe a lights this place");
  stand({0.0, 1.6, 1.0});
  key(Qt::Key_P, Qt::ShiftModifier);
  EXPECT_EQ(selected(), "b");
  stand({-30.0, 1.6, 0.0});
  key(Qt::Key_P, Qt::ShiftModifier);
  EXPECT_EQ(selected(), "a");
  EXPECT_EQ(window_->statusBar()->currentMessage(), "No probe lights this place; a is the nearest");
  EXPECT_FALSE(document().canUndo()) << "selecting edits nothing";
}

TEST_F(SelectHereTest, ADoubleClickSelectsTheProbeThatLightsTheSurface) {
  window_->viewport().setFocus();
  // Not where a handle is: those of the selected probe are put away with its mode.
  window_->probeWidget().setMode(HandleMode::Origin);
  const Camera before = window_->renderer().currentCamera();
  doubleClick(pixelOf({0.6, 0.0, -1.5}));
  EXPECT_EQ(selected(), "b");
  doubleClick(pixelOf({1.8, 0.0, -1.5}));
  EXPECT_EQ(selected(), "c");
  EXPECT_EQ(window_->renderer().currentCamera().position, before.position) << "and the view stays";
  EXPECT_FALSE(document().canUndo());
  window_->probeWidget().setMode(HandleMode::Box);
}

}  // namespace
}  // namespace boxprobe
