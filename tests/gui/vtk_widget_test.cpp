// vtkReflectionProbes in somebody else's Qt program: VTK's own widget, whose window has a context only once it is
// shown.
#include <QVTKOpenGLNativeWidget.h>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QSurfaceFormat>
#include <string>
#include <vector>

#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/actors/vtkReflectionProbes.h"
#include "tests/image/vtk_room.h"

namespace {

using namespace boxprobe::test;

std::array<int, 3> colorAt(const QImage& image, int x, int y) {
  const QColor color = image.pixelColor(x, y);
  return {color.red(), color.green(), color.blue()};
}

/// Until the widget has drawn, or ten seconds.
QImage drawn(QVTKOpenGLNativeWidget& widget) {
  QElapsedTimer timer;
  timer.start();
  do {
    QApplication::processEvents(QEventLoop::AllEvents, 50);
  } while (timer.elapsed() < 300);
  widget.renderWindow()->Render();
  QApplication::processEvents();
  return widget.grabFramebuffer();
}

TEST(VtkWidget, ProbesAreMadeBeforeItIsShown) {
  Room room;
  room.window->RemoveRenderer(room.renderer);
  QVTKOpenGLNativeWidget widget;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  widget.setRenderWindow(window);
  widget.resize(160, 160);
  window->AddRenderer(room.renderer);

  vtkNew<vtkReflectionProbe> probe;
  probe->SetBounds(-2, 2, -1, 1, -2, 2);
  probe->SetFaceSize(64);
  vtkNew<vtkReflectionProbes> probes;
  std::vector<std::string> errors;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&errors);
  listener->SetCallback([](vtkObject*, unsigned long, void* client, void* text) {
    static_cast<std::vector<std::string>*>(client)->emplace_back(static_cast<const char*>(text));
  });
  probes->AddObserver(vtkCommand::ErrorEvent, listener);
  probes->SetRenderer(room.renderer);
  probes->AddProbe(probe);
  probes->SetSeenByProbes(room.floor, false);
  // Too early: one line, and no harm done.
  EXPECT_FALSE(probes->Update());
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("no OpenGL context yet"), std::string::npos) << errors[0];

  widget.show();
  expectNear(colorAt(drawn(widget), kMirroredX, kMirroredY), {128, 128, 128}, 2);
  room.others[2]->GetProperty()->SetColor(1.0, 0.5, 0.0);
  expectNear(colorAt(drawn(widget), kMirroredX, kMirroredY), {255, 128, 0}, 2);
  widget.resize(200, 160);
  drawn(widget);
  EXPECT_EQ(errors.size(), 1u) << errors.back();
  probes->SetRenderer(nullptr);
  window->RemoveRenderer(room.renderer);
}

}  // namespace

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
