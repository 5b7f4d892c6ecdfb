// The path tracer's thin films against closed forms, the characteristic matrix of a layer, and CIE's own tables; and
// how a material's film reaches its picture.
#include "filters/reference/path/path_film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <memory>

#include "filters/reference/path/reference_path.h"

namespace boxprobe {
namespace {

constexpr PathFilm::Base kPlain = PathFilm::Base::Dielectric, kMetal = PathFilm::Base::Metal;
constexpr double kTurn = 6.28318530717958647692;

double f0Of(double index) {
  return std::pow((index - 1.0) / (index + 1.0), 2.0);
}

/// Fresnel's equations for a plain interface, unpolarised.
double plainFresnel(double index, double cosine) {
  const double t = std::sqrt(1.0 - (1.0 - cosine * cosine) / (index * index));
  const double s = (cosine - index * t) / (cosine + index * t), p = (index * cosine - t) / (index * cosine + t);
  return 0.5 * (s * s + p * p);
}

/// By the layer's characteristic matrix (Abelès) instead of a sum over ways.
double byMatrix(double film, double base, double thickness, double cosine, double wavelength) {
  using Complex = std::complex<double>;
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const double inFilm = std::sqrt(1.0 - std::pow(sine / film, 2.0)),
               inBase = std::sqrt(1.0 - std::pow(sine / base, 2.0));
  const double delta = kTurn * film * thickness * inFilm / wavelength;
  double sum = 0.0;
  for (const bool s : {true, false}) {
    const double a = s ? cosine : 1.0 / cosine, f = s ? film * inFilm : film / inFilm,
                 b = s ? base * inBase : base / inBase;
    const Complex i(0.0, 1.0), field = std::cos(delta) + i * std::sin(delta) * b / f,
                               other = i * f * std::sin(delta) + std::cos(delta) * b;
    sum += 0.5 * std::norm((a * field - other) / (a * field + other));
  }
  return sum;
}

TEST(PathFilm, OneWavelengthIsTheClosedForms) {
  for (const double base : {1.0, 1.27, 1.83, 6.4, 41.0}) {
    SCOPED_TRACE(base);
    for (const double cosine : {0.97, 0.71, 0.42, 0.13}) {
      // No film, and one of what lies under it.
      EXPECT_NEAR(PathFilm::atWavelength(kPlain, 1.41, base, 0.0, cosine, 533.0), plainFresnel(base, cosine), 1e-9);
      EXPECT_NEAR(PathFilm::atWavelength(kPlain, base, base, 377.0, cosine, 533.0), plainFresnel(base, cosine), 1e-9);
      for (const double thickness : {41.0, 233.0, 1890.0}) {
        EXPECT_NEAR(PathFilm::atWavelength(kPlain, 1.41, base, thickness, cosine, 611.0),
                    byMatrix(1.41, base, thickness, cosine, 611.0), 1e-9);
      }
    }
    // Half a wave is as none, a quarter turns the base's index over.
    const double film = 1.62, wavelength = 587.0, half = 0.5 * wavelength / film;
    EXPECT_NEAR(PathFilm::atWavelength(kPlain, film, base, half, 1.0, wavelength), f0Of(base), 1e-9);
    EXPECT_NEAR(PathFilm::atWavelength(kPlain, film, base, 0.5 * half, 1.0, wavelength), f0Of(film * film / base),
                1e-9);
  }
}

TEST(PathFilm, WithoutThicknessTheBaseIsSeenAndStraightOnItsF0) {
  const PathFilm film(kPlain, 1.47, 0.0, 0.0);
  const glm::dvec3 f0(0.043, 0.31, 0.87), seen = film.reflectance(f0, 0.0, 1.0);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], f0[c], 1e-3) << c;
  for (const double cosine : {0.83, 0.57, 0.29, 0.11}) {
    const glm::dvec3 aside = film.reflectance(glm::dvec3(f0Of(1.36), f0Of(1.9), f0Of(3.3)), 0.0, cosine);
    EXPECT_NEAR(aside.x, plainFresnel(1.36, cosine), 2e-3) << cosine;
    EXPECT_NEAR(aside.y, plainFresnel(1.9, cosine), 2e-3) << cosine;
    EXPECT_NEAR(aside.z, plainFresnel(3.3, cosine), 2e-3) << cosine;
  }
}

// CIE 1931 and D65 as CIE tabulates them, every 20 nanometres, in the place of the fit.
TEST(PathFilm, ColoursAreThoseOfTheTabulatedObserver) {
  constexpr double kObserver[][3] = {
      {0.0143, 0.0004, 0.0679}, {0.1344, 0.0040, 0.6456}, {0.3483, 0.0230, 1.7471}, {0.2908, 0.0600, 1.6692},
      {0.0956, 0.1390, 0.8130}, {0.0049, 0.3230, 0.2720}, {0.0633, 0.7100, 0.0782}, {0.2904, 0.9540, 0.0203},
      {0.5945, 0.9950, 0.0039}, {0.9163, 0.8700, 0.0017}, {1.0622, 0.6310, 0.0008}, {0.8544, 0.3810, 0.0002},
      {0.4479, 0.1750, 0.0000}, {0.1649, 0.0610, 0.0000}, {0.0468, 0.0170, 0.0000}, {0.0114, 0.0041, 0.0000}};
  constexpr double kDaylight[] = {82.75,  93.43, 104.87, 117.81, 115.92, 109.35, 104.79, 104.41,
                                  100.00, 95.79, 90.01,  87.70,  83.70,  80.21,  78.28,  71.61};
  double worst = 0.0;
  for (const double ior : {1.29, 1.74}) {
    const PathFilm film(kPlain, ior, 70.0, 430.0);
    for (const double base : {1.52, 5.7}) {
      for (const double thickness : {97.0, 188.0, 301.0, 425.0}) {
        for (const double cosine : {1.0, 0.66, 0.35}) {
          glm::dvec3 seen(0.0), white(0.0);
          for (std::size_t i = 0; i < std::size(kDaylight); ++i) {
            const auto* o = kObserver[i];
            const glm::dvec3 rgb = kDaylight[i] * glm::dvec3(3.2406 * o[0] - 1.5372 * o[1] - 0.4986 * o[2],
                                                             -0.9689 * o[0] + 1.8758 * o[1] + 0.0415 * o[2],
                                                             0.0557 * o[0] - 0.2040 * o[1] + 1.0570 * o[2]);
            white += rgb;
            seen += rgb * byMatrix(ior, base, thickness, cosine, 400.0 + 20.0 * static_cast<double>(i));
          }
          const glm::dvec3 found = film.reflectance(glm::dvec3(f0Of(base)), thickness, cosine);
          for (int c = 0; c < 3; ++c) {
            worst = std::max(worst, std::abs(found[c] - std::clamp(seen[c] / white[c], 0.0, 1.0)));
          }
        }
      }
    }
  }
  std::printf("  worst %.4f of the light\n", worst);
  EXPECT_LT(worst, 0.01);
}

// As bright as between its dimmest and its brightest wavelength, which is no brighter than what falls on it.
TEST(PathFilm, ReflectsNeverMoreThanThereIs) {
  const PathFilm film(kPlain, 1.83, 0.0, 900.0);
  for (const double base : {1.0, 2.9, 11.0}) {
    for (int i = 0; i <= 900; i += 37) {
      for (int c = 1; c <= 20; ++c) {
        double least = 1.0, most = 0.0;
        for (int w = 380; w <= 780; w += 3) {
          const double one = PathFilm::atWavelength(kPlain, 1.83, base, i, 0.05 * c, w);
          least = std::min(least, one);
          most = std::max(most, one);
        }
        ASSERT_TRUE(least >= 0.0 && most <= 1.0 + 1e-12) << i << " nm, " << c;
        const glm::dvec3 seen = film.reflectance(glm::dvec3(f0Of(base)), i, 0.05 * c);
        const double brightness = glm::dot(seen, {0.2126, 0.7152, 0.0722});
        ASSERT_TRUE(brightness >= least - 2e-3 && brightness <= most + 2e-3) << i << " nm, " << c;
      }
    }
  }
  // All light at a flat angle, whatever the film.
  EXPECT_NEAR(film.reflectance({0.04, 0.3, 0.9}, 333.0, 0.0).y, 1.0, 1e-6);
}

// Straight on a metal is what its index says, and a film without thickness leaves Schlick's curve, by which glTF
// defines metals: it does not darken at a Brewster angle.
TEST(PathFilm, AMetalKeepsItsLightAtFlatAngles) {
  for (const double base : {3.1, 12.0, 66.0}) {
    SCOPED_TRACE(base);
    for (const double thickness : {0.0, 119.0, 282.0}) {
      EXPECT_NEAR(PathFilm::atWavelength(kMetal, 1.38, base, thickness, 1.0, 498.0),
                  PathFilm::atWavelength(kPlain, 1.38, base, thickness, 1.0, 498.0), 1e-9);
      for (const double cosine : {0.81, 0.44, 0.07}) {
        const double seen = PathFilm::atWavelength(kMetal, 1.38, base, thickness, cosine, 498.0);
        EXPECT_LE(seen, 1.0 + 1e-12);
      }
    }
    for (const double cosine : {0.81, 0.44, 0.17, 0.07}) {
      const double schlick = f0Of(base) + (1.0 - f0Of(base)) * std::pow(1.0 - cosine, 5.0);
      EXPECT_NEAR(PathFilm::atWavelength(kMetal, 1.38, base, 0.0, cosine, 498.0), schlick, 1e-9) << cosine;
    }
  }
}

// Waves that are out of step add as light does: the mean over a turn of the phase.
TEST(PathFilm, AThickFilmHasNoColour) {
  const double ior = 1.45, base = 2.6, cosine = 0.74, outer = plainFresnel(ior, 1.0), inner = f0Of(base / ior);
  const PathFilm film(kPlain, ior, 11500.0, 11500.0);
  const glm::dvec3 straight = film.reflectance(glm::dvec3(f0Of(base)), 11500.0, 1.0);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(straight[c], outer + (1 - outer) * (1 - outer) * inner / (1 - outer * inner), 0.01) << c;
  }
  const glm::dvec3 aside = film.reflectance(glm::dvec3(f0Of(base)), 11500.0, cosine);
  EXPECT_NEAR(aside.x, aside.z, 0.01);
}

/// A square in a white sky, seen under an angle whose cosine is `cosine`.
glm::dvec3 filmSeen(const Material& material, double cosine) {
  Model model;
  Mesh mesh;
  mesh.positions = {{-90, 0, 90}, {90, 0, 90}, {90, 0, -90}, {-90, 0, -90}};
  mesh.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.material = 0;
  model.materials.push_back(material);
  model.instances.push_back({"floor", 0, glm::dmat4(1.0)});
  model.meshes.push_back(mesh);
  Scene scene;
  scene.sky = SkyColor{{1.0f, 1.0f, 1.0f}};
  scene.models.emplace_back();
  scene.models.back().file = "made.glb";
  Camera camera;
  camera.position = {std::sqrt(1.0 - cosine * cosine), cosine, 0.0};
  camera.target = {0.0, 0.0, 0.0};
  camera.up = {0.0, 0.0, 1.0};
  camera.verticalFovDegrees = 0.01;
  PathSettings settings;
  settings.width = settings.height = 1;
  settings.raysPerPixel = 4096;
  const ReferencePicture picture =
      ReferencePath(scene, {std::make_shared<const Model>(model)}, nullptr).render(camera, settings);
  return {picture.color.pixels[0], picture.color.pixels[1], picture.color.pixels[2]};
}

void expectNear3(const glm::dvec3& found, const glm::dvec3& expected, double within) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], within) << c;
}

TEST(PathFilm, AMirrorShowsItsFilm) {
  Material metal;
  metal.baseColor = {0.91f, 0.64f, 0.37f, 1.0f};
  metal.roughness = 0.0f;
  metal.finish.iridescence = 1.0f;
  metal.finish.filmIor = 1.56f;
  metal.finish.filmThicknessMin = 130.0f;
  metal.finish.filmThicknessMax = 340.0f;
  const glm::dvec3 f0(metal.baseColor);
  const double cosine = 0.61;
  const PathFilm film(kMetal, 1.56, 130.0, 340.0);
  const glm::dvec3 whole = film.reflectance(f0, 340.0, cosine), bare = f0 + (1.0 - f0) * std::pow(1.0 - cosine, 5.0);
  ASSERT_GT(glm::length(whole - bare), 0.1);
  // Without a texture the film has its greatest thickness.
  expectNear3(filmSeen(metal, cosine), whole, 3e-3);
  metal.finish.iridescence = 0.3f;
  expectNear3(filmSeen(metal, cosine), 0.3 * whole + 0.7 * bare, 3e-3);
  metal.finish.iridescence = 0.0f;
  expectNear3(filmSeen(metal, cosine), bare, 1e-4);
  // Textures: red of the share, green of the thickness.
  const auto texture = [](std::uint8_t r, std::uint8_t g) {
    auto image = std::make_shared<ImageRgba8>();
    image->width = image->height = 1;
    image->pixels = {r, g, 0, 255};
    TextureUse use;
    use.image = image;
    return use;
  };
  metal.finish.iridescence = 0.5f;
  metal.finish.iridescenceTexture = texture(204, 0);
  metal.finish.filmThicknessTexture = texture(0, 51);
  expectNear3(filmSeen(metal, cosine), 0.4 * film.reflectance(f0, 130.0 + 0.2 * 210.0, cosine) + 0.6 * bare, 3e-3);
}

// What the film reflects does not reach the paint below it; smooth, so that the paint has no microfacets' angles.
TEST(PathFilm, PaintUnderAFilmGetsWhatIsLeft) {
  Material paint;
  paint.metallic = 0.0f;
  paint.roughness = 0.0f;
  paint.baseColor = {0.0f, 0.0f, 0.0f, 1.0f};
  paint.finish.iridescence = 1.0f;
  paint.finish.filmIor = 2.1f;
  paint.finish.filmThicknessMax = 260.0f;
  const double cosine = 0.83;
  const glm::dvec3 film = PathFilm(kPlain, 2.1, 260.0, 260.0).reflectance(glm::dvec3(0.04), 260.0, cosine);
  expectNear3(filmSeen(paint, cosine), film, 3e-3);
  paint.baseColor = {1.0f, 1.0f, 1.0f, 1.0f};
  const glm::dvec3 white = filmSeen(paint, cosine);
  for (int c = 0; c < 3; ++c) {
    EXPECT_GT(white[c], film[c] + 0.3);
    EXPECT_LE(white[c], 1.0 + 1e-3);
  }
}

}  // namespace
}  // namespace boxprobe
