// A window without a window system, on a device that EGL lists: what drivers have whose default display asks for one.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <string>

#include "app/session/surfaceless_window.h"

namespace {

TEST(Surfaceless, ADeviceDrawsWhereThereIsNoOtherDisplay) {
  const char* offered = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (offered == nullptr || std::string(offered).find("EGL_EXT_platform_device") == std::string::npos) {
    GTEST_SKIP() << "EGL lists no devices here";
  }
  std::string why;
  const auto window = boxprobe::makeSurfacelessWindow(why, true);
  ASSERT_TRUE(window) << why;
  EXPECT_EQ(why, "");
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.2, 0.4, 0.8);
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(7, 5);
  window->AddRenderer(renderer);
  window->Initialize();
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixel;
  ASSERT_TRUE(window->GetPixelData(3, 2, 3, 2, 0, pixel, 0));
  EXPECT_EQ(pixel->GetTypedComponent(0, 0), 51);
  EXPECT_EQ(pixel->GetTypedComponent(0, 1), 102);
  EXPECT_EQ(pixel->GetTypedComponent(0, 2), 204);
}

}  // namespace
