// The surroundings that probes on a program's own actors read from a vtkRenderer, texel by texel: pictures of each kind
// of number, cubes by OpenGL's specification of their faces, backgrounds, axes, and what counts as a change.
#include "filters/vtk/actors/surroundings.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPointData.h>
#include <vtkTexture.h>

#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

namespace boxprobe {
namespace {

using Value = std::function<double(int x, int y, int component)>;

vtkSmartPointer<vtkImageData> image(int width, int height, int type, int components, const Value& value) {
  auto made = vtkSmartPointer<vtkImageData>::New();
  made->SetDimensions(width, height, 1);
  made->AllocateScalars(type, components);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < components; ++c) made->SetScalarComponentFromDouble(x, y, 0, c, value(x, y, c));
    }
  }
  return made;
}

double linearOfSrgbNumber(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// Where a world direction is looked up in VTK's frame of the environment.
void expectAxes(const glm::dmat3& found, const glm::dvec3& right, const glm::dvec3& up,
                const std::array<glm::dvec3, 3>& wanted) {
  const glm::dvec3 front = glm::cross(right, up);
  const std::array<glm::dvec3, 3> from = {right, up, front};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(glm::length(found * from[i] - wanted[i]), 1e-12) << i;
}

struct Lit {
  Lit() { renderer->UseImageBasedLightingOn(); }
  vtkNew<vtkOpenGLRenderer> renderer;
  vtkNew<vtkTexture> texture;
  RendererSurroundings surroundings;
};

void expectPicture(const OrientedSky* sky, int width, int height, const Value& wanted) {
  ASSERT_NE(sky, nullptr);
  ASSERT_NE(sky->image, nullptr);
  ASSERT_EQ(sky->image->width, width);
  ASSERT_EQ(sky->image->height, height);
  ASSERT_EQ(sky->image->pixels.size(), static_cast<std::size_t>(width * height * 4));
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const float* p = &sky->image->pixels[static_cast<std::size_t>(row * width + column) * 4];
      for (int c = 0; c < 3; ++c) {
        // Rows from the top here, from below in VTK.
        const double value = wanted(column, height - 1 - row, c);
        EXPECT_NEAR(p[c], value, 1e-5 * std::max(1.0, value)) << column << ", " << row << ", " << c;
      }
      EXPECT_EQ(p[3], 1.0f);
    }
  }
}

TEST(Surroundings, ArePicturesOfEachKindOfNumberTexelByTexel) {
  const Value floats = [](int x, int y, int c) {
    if (x == 1 && y == 2) return c == 0 ? std::numeric_limits<double>::quiet_NaN() : c == 1 ? -3.0 : 0.02;
    return 0.05 + 0.13 * x + 1.7 * y + 0.31 * c;
  };
  {
    Lit lit;
    lit.texture->SetInputData(image(5, 3, VTK_FLOAT, 3, floats));
    lit.renderer->SetEnvironmentTexture(lit.texture);
    ASSERT_TRUE(lit.surroundings.read(lit.renderer, Tone::AsVtk));
    expectPicture(lit.surroundings.light(), 5, 3, [&](int x, int y, int c) {
      const double value = floats(x, y, c);
      return std::isfinite(value) ? std::max(value, 0.0) : 0.0;
    });
    EXPECT_EQ(lit.surroundings.backdrop().image, lit.surroundings.light()->image);
    expectAxes(lit.surroundings.light()->pictureFromWorld, {1, 0, 0}, {0, 1, 0}, {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}});
    lit.renderer->SetEnvironmentUp(0, 0, 1);
    lit.renderer->SetEnvironmentRight(0, 1, 0);
    ASSERT_TRUE(lit.surroundings.read(lit.renderer, Tone::AsVtk));
    expectAxes(lit.surroundings.light()->pictureFromWorld, {0, 1, 0}, {0, 0, 1}, {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}});
  }
  const Value bytes = [](int x, int y, int c) { return 7.0 + 41.0 * x + 23.0 * y + 3.0 * c; };
  {
    Lit lit;  // one channel, of display colours
    lit.texture->SetInputData(image(4, 3, VTK_UNSIGNED_CHAR, 1, bytes));
    lit.texture->UseSRGBColorSpaceOn();
    lit.renderer->SetEnvironmentTexture(lit.texture);
    ASSERT_TRUE(lit.surroundings.read(lit.renderer, Tone::AsVtk));
    expectPicture(lit.surroundings.light(), 4, 3,
                  [&](int x, int y, int) { return linearOfSrgbNumber(bytes(x, y, 0) / 255.0); });
  }
  {
    Lit lit;  // by the flag that tells VTK's filters of a power
    lit.texture->SetInputData(image(3, 4, VTK_UNSIGNED_CHAR, 3, bytes));
    lit.renderer->SetEnvironmentTexture(lit.texture, true);
    ASSERT_TRUE(lit.surroundings.read(lit.renderer, Tone::None));
    expectPicture(lit.surroundings.light(), 3, 4,
                  [&](int x, int y, int c) { return std::pow(bytes(x, y, c) / 255.0, 2.2); });
  }
  {
    Lit lit;
    const Value words = [](int x, int y, int c) { return 900.0 + 11000.0 * x + 4100.0 * y + 1700.0 * c; };
    lit.texture->SetInputData(image(3, 2, VTK_UNSIGNED_SHORT, 4, words));
    lit.renderer->SetEnvironmentTexture(lit.texture);
    ASSERT_TRUE(lit.surroundings.read(lit.renderer, Tone::AsVtk));
    expectPicture(lit.surroundings.light(), 3, 2, [&](int x, int y, int c) { return words(x, y, c) / 65535.0; });
  }
}

// Table 8.19 of OpenGL 4.6, by major axis: which coordinate is s, which is t, and their signs.
struct CubeFace {
  int s, t;
  double signS, signT;
};
constexpr std::array<CubeFace, 6> kCubeFaces = {
    {{2, 1, -1, -1}, {2, 1, 1, -1}, {0, 2, 1, 1}, {0, 2, 1, -1}, {0, 1, 1, -1}, {0, 1, -1, -1}}};

TEST(Surroundings, AreCubesByOpenGlsFaces) {
  constexpr int kSide = 3;
  const auto texel = [](int face, int x, int y, int c) { return 0.2 + 1.9 * face + 0.37 * x + 0.11 * y + 0.05 * c; };
  Lit lit;
  lit.texture->CubeMapOn();
  for (int face = 0; face < 6; ++face) {
    lit.texture->SetInputData(
        face, image(kSide, kSide, VTK_FLOAT, 3, [&](int x, int y, int c) { return texel(face, x, y, c); }));
  }
  lit.renderer->SetEnvironmentTexture(lit.texture);
  ASSERT_TRUE(lit.surroundings.read(lit.renderer, Tone::AsVtk));
  ASSERT_NE(lit.surroundings.light(), nullptr);
  expectAxes(lit.surroundings.light()->pictureFromWorld, {1, 0, 0}, {0, 1, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  constexpr int kHeight = 4 * kSide, kWidth = 2 * kHeight;
  expectPicture(lit.surroundings.light(), kWidth, kHeight, [&](int column, int fromBelow, int c) {
    const double pi = std::acos(-1.0);
    const double latitude = pi * ((fromBelow + 0.5) / kHeight - 0.5),
                 longitude = pi * (1.0 - 2.0 * (column + 0.5) / kWidth);
    const std::array<double, 3> d = {std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                     std::cos(latitude) * std::cos(longitude)};
    std::size_t major = 0;
    for (const std::size_t axis : {1u, 2u}) {
      if (std::abs(d[axis]) > std::abs(d[major])) major = axis;
    }
    const std::size_t face = 2 * major + (d[major] < 0.0 ? 1 : 0);
    const CubeFace& f = kCubeFaces[face];
    const double s = 0.5 * (f.signS * d[static_cast<std::size_t>(f.s)] / std::abs(d[major]) + 1.0) * kSide - 0.5;
    const double t = 0.5 * (f.signT * d[static_cast<std::size_t>(f.t)] / std::abs(d[major]) + 1.0) * kSide - 0.5;
    // Linear in both, so that between texels it is the formula itself; constant beyond the outer texels' middles.
    const double x = std::min(std::max(s, 0.0), kSide - 1.0), y = std::min(std::max(t, 0.0), kSide - 1.0);
    return 0.2 + 1.9 * static_cast<double>(face) + 0.37 * x + 0.11 * y + 0.05 * c;
  });

  Lit five;
  five.texture->CubeMapOn();
  for (const int face : {0, 1, 2, 3, 5}) {
    five.texture->SetInputData(face, image(2, 2, VTK_FLOAT, 3, [](int, int, int) { return 0.5; }));
  }
  five.renderer->SetEnvironmentTexture(five.texture);
  ASSERT_TRUE(five.surroundings.read(five.renderer, Tone::AsVtk));
  EXPECT_EQ(five.surroundings.light(), nullptr);
  EXPECT_EQ(five.surroundings.problem(),
            "the renderer's environment texture has no image for face 4 of its cube; set its six inputs");
}

TEST(Surroundings, AreBackgroundsWithoutATexture) {
  vtkNew<vtkOpenGLRenderer> renderer;
  renderer->SetBackground(0.2, 0.55, 0.03);
  renderer->SetBackground2(0.9, 0.01, 0.4);
  renderer->SetEnvironmentUp(0, 0, 1);
  renderer->SetEnvironmentRight(0, 1, 0);
  RendererSurroundings surroundings;
  ASSERT_TRUE(surroundings.read(renderer, Tone::AsVtk));
  EXPECT_EQ(surroundings.light(), nullptr);
  EXPECT_EQ(surroundings.backdrop().image, nullptr);
  expectAxes(surroundings.backdrop().pictureFromWorld, {0, 1, 0}, {0, 0, 1}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  const auto* plain = std::get_if<SkyColor>(&surroundings.backdrop().sky);
  ASSERT_NE(plain, nullptr);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(plain->color[c], std::pow(renderer->GetBackground()[c], 2.2), 1e-6);
  renderer->GradientBackgroundOn();
  ASSERT_TRUE(surroundings.read(renderer, Tone::Agx));
  const auto* gradient = std::get_if<SkyGradient>(&surroundings.backdrop().sky);
  ASSERT_NE(gradient, nullptr);
  for (int c = 0; c < 3; ++c) {
    const double low = linearOfSrgbNumber(renderer->GetBackground()[c]);
    const double high = linearOfSrgbNumber(renderer->GetBackground2()[c]);
    EXPECT_NEAR(gradient->ground[c], low, 1e-6);
    EXPECT_NEAR(gradient->horizon[c], 0.5 * (low + high), 1e-6);
    EXPECT_NEAR(gradient->top[c], high, 1e-6);
  }
}

TEST(Surroundings, AreReadAgainOnlyAfterAChange) {
  Lit lit;
  const vtkSmartPointer<vtkImageData> picture =
      image(2, 2, VTK_FLOAT, 3, [](int x, int y, int) { return x + 2.0 * y; });
  vtkOpenGLRenderer* renderer = lit.renderer;
  Tone tone = Tone::AsVtk;
  ASSERT_TRUE(lit.surroundings.read(renderer, tone));
  const std::vector<std::pair<const char*, std::function<void()>>> changes = {
      {"texture without an image", [&] { renderer->SetEnvironmentTexture(lit.texture); }},
      {"an image", [&] { lit.texture->SetInputData(picture); }},
      {"the image's values",
       [&] {
         picture->SetScalarComponentFromDouble(1, 0, 0, 2, 5.0);
         picture->Modified();
       }},
      {"sRGB", [&] { lit.texture->UseSRGBColorSpaceOn(); }},
      {"light off", [&] { renderer->UseImageBasedLightingOff(); }},
      {"red", [&] { renderer->SetBackground(0.1, 0.0, 0.0); }},
      {"green", [&] { renderer->SetBackground(0.1, 0.1, 0.0); }},
      {"blue", [&] { renderer->SetBackground(0.1, 0.1, 0.1); }},
      {"another red", [&] { renderer->SetBackground2(0.3, 0.2, 0.2); }},
      {"another blue", [&] { renderer->SetBackground2(0.3, 0.2, 0.5); }},
      {"gradient", [&] { renderer->GradientBackgroundOn(); }},
      {"up", [&] { renderer->SetEnvironmentUp(0, 0.8, 0.6); }},
      {"right", [&] { renderer->SetEnvironmentRight(0.6, 0.8, 0.0); }},
      {"tone", [&] { tone = Tone::Neutral; }},
      {"light on", [&] { renderer->UseImageBasedLightingOn(); }},
      {"no texture", [&] { renderer->SetEnvironmentTexture(nullptr); }}};
  for (const auto& [what, change] : changes) {
    EXPECT_FALSE(lit.surroundings.read(renderer, tone)) << "before: " << what;
    change();
    EXPECT_TRUE(lit.surroundings.read(renderer, tone)) << what;
    const std::string name = what;
    EXPECT_EQ(lit.surroundings.problem().empty(), name != "texture without an image") << what;
    EXPECT_EQ(lit.surroundings.light() != nullptr,
              name == "an image" || name == "the image's values" || name == "sRGB" || name == "light on")
        << what;
  }
  EXPECT_FALSE(lit.surroundings.read(renderer, Tone::Aces)) << "the same curve";
}

}  // namespace
}  // namespace boxprobe
