// Display colours made by roots are those of sRGB's curve, to a fiftieth of an 8-bit step.
#include <gtest/gtest.h>
#include <vtkOpenGLState.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "filters/vtk/draw/display_source.h"
#include "filters/vtk/gl/full_screen_pass.h"
#include "filters/vtk/gl/gl_objects.h"
#include "filters/vtk/gl/opengl.h"
#include "tests/support/gpu_window.h"
#include "tests/support/shown_light.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kSide = 256;

// Light from 0 to 1, most of it dark, where the power is steep; in the second half from 1 to beyond all bounds.
constexpr const char* kMain = R"(
in vec2 texCoord;
void main()
{
  float u = (floor(gl_FragCoord.x) + 256.0 * floor(gl_FragCoord.y)) / 65535.0;
  float light = u < 0.5 ? 16.0 * u * u * u * u : exp2(256.0 * (u - 0.5));
  gl_FragData[0] = vec4(light, bpDisplayed(vec3(light)).r, 0.0, 1.0);
}
)";

TEST(DisplayColor, OfRootsIsTheCurve) {
  const auto window = makeWindow();
  FloatTarget target;
  target.allocate(kSide, kSide);
  FullScreenPass pass("display colour",
                      joinShaderSources({"gpu/output_uniforms.glsl"}) + displaySource(Tone::None, true) + kMain);
  std::vector<float> values(4 * static_cast<std::size_t>(kSide) * kSide);
  {
    const PassState saved(window);
    window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    window->GetState()->vtkglViewport(0, 0, kSide, kSide);
    pass.draw(window, [](vtkShaderProgram*) {});
    glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_FLOAT, values.data());
  }
  pass.release();
  double worst = 0.0;
  for (std::size_t i = 0; i < values.size(); i += 4) {
    const double light = values[i], shown = values[i + 1];
    if (light > 1.0) {
      ASSERT_GE(shown, 1.0) << "of light " << light;  // also of infinite light, which no NaN may come of
    } else {
      worst = std::max(worst, std::abs(shown - shownLight(light)));
    }
  }
  std::printf("  at most %.2e, %.3f of an 8-bit step\n", worst, 255.0 * worst);
  EXPECT_LE(255.0 * worst, 0.02);
}

}  // namespace
