// Glass as drawn against glass ray traced, object by object and form by form, from outside and from within; that an
// index of 1 is not there, that the critical angle is where it belongs, and what a scene without glass pays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>

#include "filters/explain/explanation_sections.h"
#include "filters/io/gltf/model_file.h"
#include "filters/reference/light/reference_scene.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 160, kHeight = 128;
const std::vector<std::string> kSolids = {"ball", "block", "prism", "ring", "cup"};

Scene glassScene() {
  return ScenePicture::fromFile("scenes/glass.boxprobe.json", 8, 8).scene;
}

/// The scene with one object of glass, the others gone.
Scene only(const std::string& object) {
  Scene scene = glassScene();
  for (const char* other : {"ball", "block", "prism", "ring", "cup", "pane"}) {
    if (object != other) scene.objects[other].visible = false;
  }
  return scene;
}

ReferenceScene referenceOf(const Scene& scene) {
  std::vector<std::shared_ptr<const Model>> models;
  for (const ModelFile& file : scene.models) models.push_back(std::make_shared<Model>(loadModelFile(file.file)));
  return ReferenceScene(scene, models, nullptr);
}

/// Root of the mean squared difference of linear radiance over the pixels that show `object`.
struct GlassError {
  double rmse = 0.0;
  double largest = 0.0;
  int pixels = 0;
  bool finite = true;
};
GlassError errorOf(const ImageRgbaF& drawn, const ReferencePicture& truth, const std::vector<bool>& shows) {
  GlassError error;
  double sum = 0.0;
  for (std::size_t i = 0; i < shows.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) error.finite = error.finite && std::isfinite(drawn.pixels[4 * i + c]);
    if (!shows[i]) continue;
    ++error.pixels;
    for (std::size_t c = 0; c < 3; ++c) {
      const double d =
          static_cast<double>(drawn.pixels[4 * i + c]) - static_cast<double>(truth.color.pixels[4 * i + c]);
      sum += d * d / 3.0;
      error.largest = std::max(error.largest, std::abs(d));
    }
  }
  error.rmse = std::sqrt(sum / std::max(error.pixels, 1));
  return error;
}

/// Pixels all of whose middle shows the object.
std::vector<bool> pixelsOf(const ReferenceScene& reference, const Camera& camera, const std::string& object) {
  std::vector<bool> shows(static_cast<std::size_t>(kWidth) * kHeight);
  const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
  const double tangent = std::tan(0.5 * camera.verticalFovDegrees * 3.14159265358979 / 180.0);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double u = (2.0 * (x + 0.5) / kWidth - 1.0) * kWidth / kHeight, v = 1.0 - 2.0 * (y + 0.5) / kHeight;
      const auto hit = reference.tracer().firstHit(camera.position, forward + tangent * (u * right + v * up));
      shows[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] =
          hit && reference.tracer().object(*hit).node == object;
    }
  }
  return shows;
}

ReferencePicture traced(const ReferenceScene& reference, const Camera& camera, int rays) {
  ReferenceSettings settings;
  settings.width = kWidth;
  settings.height = kHeight;
  settings.samplesPerPixel = 4;
  settings.raysPerPixel = rays;
  return reference.render(camera, settings);
}

const char* const kForms[] = {"auto", "one-pass", "two-pass", "two-interface"};

struct Measured {
  std::map<GlassForm, GlassError> forms;
};
Measured measure(const std::string& object, const std::string& camera, float roughness, float ior,
                 const std::vector<GlassForm>& forms) {
  Scene scene = only(object);
  scene.materials[object].roughness = roughness;
  scene.materials[object].ior = ior;
  const Camera view = cameraNamed(scene, camera);
  const ReferenceScene reference = referenceOf(scene);
  const ReferencePicture truth = traced(reference, view, roughness > 0.0f ? 64 : 4);
  const std::vector<bool> shows = pixelsOf(reference, view, object);
  keepPicture(truth.color, "glass " + camera + " " + std::to_string(roughness).substr(0, 3) + " " +
                               std::to_string(ior).substr(0, 4) + " reference");
  ScenePicture picture(scene, kWidth, kHeight);
  Measured measured;
  for (const GlassForm form : forms) {
    picture.scene.materials[object].glass = form;
    picture.show(view);
    const ImageRgbaF drawn = picture.linear(4);
    keepPicture(drawn, "glass " + camera + " " + std::to_string(roughness).substr(0, 3) + " " +
                           std::to_string(ior).substr(0, 4) + " " + kForms[static_cast<int>(form)]);
    measured.forms[form] = errorOf(drawn, truth, shows);
  }
  return measured;
}

// Bounds: what was measured on llvmpipe, and a fifth more.
struct Bound {
  const char* object;
  float roughness;
  double onePass, twoPass, twoInterface, automatic;
};
const Bound kBounds[] = {
    {"ball", 0.0f, 0.27, 0.22, 0.028, 0.028},    {"block", 0.0f, 0.18, 0.17, 0.029, 0.029},
    {"prism", 0.0f, 0.20, 0.19, 0.054, 0.054},   {"ring", 0.0f, 0.14, 0.14, 0.15, 0.14},
    {"cup", 0.0f, 0.24, 0.19, 0.25, 0.15},       {"ball", 0.3f, 0.14, 0.11, 0.039, 0.039},
    {"block", 0.3f, 0.065, 0.070, 0.030, 0.030}, {"prism", 0.3f, 0.090, 0.070, 0.043, 0.043},
    {"ring", 0.3f, 0.070, 0.070, 0.080, 0.070},  {"cup", 0.3f, 0.12, 0.085, 0.12, 0.063},
};

TEST(Glass, FormsAgainstTheRayTracedObject) {
  const std::vector<GlassForm> forms = {GlassForm::OnePass, GlassForm::TwoPass, GlassForm::TwoInterface,
                                        GlassForm::Automatic};
  std::printf("  RMSE of linear radiance          one-pass  two-pass  two-interface  auto\n");
  for (const Bound& bound : kBounds) {
    const Measured m = measure(bound.object, bound.object, bound.roughness, 1.5f, forms);
    std::printf("  %-6s roughness %.1f (%5d pixels)  %.4f    %.4f    %.4f         %.4f\n", bound.object,
                static_cast<double>(bound.roughness), m.forms.at(GlassForm::OnePass).pixels,
                m.forms.at(GlassForm::OnePass).rmse, m.forms.at(GlassForm::TwoPass).rmse,
                m.forms.at(GlassForm::TwoInterface).rmse, m.forms.at(GlassForm::Automatic).rmse);
    for (const auto& [form, error] : m.forms) {
      EXPECT_TRUE(error.finite) << bound.object << " " << kForms[static_cast<int>(form)];
      EXPECT_GT(error.pixels, 1000) << bound.object;
    }
    EXPECT_LT(m.forms.at(GlassForm::OnePass).rmse, bound.onePass) << bound.object;
    EXPECT_LT(m.forms.at(GlassForm::TwoPass).rmse, bound.twoPass) << bound.object;
    EXPECT_LT(m.forms.at(GlassForm::TwoInterface).rmse, bound.twoInterface) << bound.object;
    EXPECT_LT(m.forms.at(GlassForm::Automatic).rmse, bound.automatic) << bound.object;
  }
}

TEST(Glass, IndicesFromOneToDiamondFromOutsideAndFromWithin) {
  std::printf("  RMSE of linear radiance, two-interface; largest difference at index 1\n");
  for (const char* camera : {"ball", "inside ball", "block", "inside block"}) {
    const std::string object = std::string(camera).find("ball") != std::string::npos ? "ball" : "block";
    std::printf("  %-13s", camera);
    for (const float ior : {1.0f, 1.33f, 1.8f, 2.4f}) {
      const Measured m = measure(object, camera, 0.0f, ior, {GlassForm::TwoInterface});
      const GlassError& error = m.forms.at(GlassForm::TwoInterface);
      std::printf("  %.2f: %.4f", static_cast<double>(ior), error.rmse);
      EXPECT_TRUE(error.finite) << camera << " " << ior;
      EXPECT_GT(error.pixels, 1000) << camera;
      EXPECT_LT(error.rmse, 0.085) << camera << " " << ior;
    }
    std::printf("\n");
  }
}

int differing(const ImageRgba8& a, const ImageRgba8& b, int& largest) {
  int count = 0;
  largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const int d = std::abs(int(a.pixels[i]) - int(b.pixels[i]));
    largest = std::max(largest, d);
    count += d > 2;
  }
  return count;
}

// An index of 1 is not there: from outside and within, clear or rough, in every form.
TEST(Glass, AnIndexOfOneIsInvisible) {
  Scene scene = glassScene();
  for (const std::string& object : kSolids) {
    scene.materials[object].ior = 1.0f;
    scene.materials[object].attenuationDistance = 0.0f;
  }
  scene.materials["pane"].ior = 1.0f;
  ScenePicture with(scene, 320, 240);
  Scene bare = scene;
  for (const char* object : {"ball", "block", "prism", "ring", "cup", "pane"}) bare.objects[object].visible = false;
  ScenePicture without(bare, 320, 240);
  for (const char* camera : {"main", "ball", "cup", "inside ball", "inside block"}) {
    const Camera view = cameraNamed(scene, camera);
    without.show(view);
    const ImageRgba8 background = without.display();
    for (const GlassForm form :
         {GlassForm::Automatic, GlassForm::OnePass, GlassForm::TwoPass, GlassForm::TwoInterface}) {
      for (const std::string& object : kSolids) {
        with.scene.materials[object].glass = form;
        with.scene.materials[object].roughness = form == GlassForm::TwoInterface ? 0.3f : 0.0f;
      }
      with.show(view);
      int largest = 0;
      EXPECT_EQ(differing(with.display(), background, largest), 0) << camera << " " << kForms[static_cast<int>(form)];
      std::printf("  %-12s %-13s largest difference %d of 255\n", camera, kForms[static_cast<int>(form)], largest);
    }
  }
  // And an index of 1.5 is seen, by the same measure.
  with.scene.materials["ball"].ior = 1.5f;
  with.show(cameraNamed(scene, "ball"));
  without.show(cameraNamed(scene, "ball"));
  int largest = 0;
  EXPECT_GT(differing(with.display(), without.display(), largest), 10000);
}

// Looked at from within, straight at a face: total reflection begins at the critical angle, in the drawn picture as in
// its account.
TEST(Glass, TheCriticalAngleIsACircle) {
  constexpr int kSize = 201;
  Scene scene = only("block");
  const float ior = 1.5f;
  scene.materials["block"].ior = ior;
  const Camera view{"within", {-0.9, 0.95, -0.3}, {-0.9, 0.95, -1.3}, {0, 1, 0}, 110.0};
  ScenePicture picture(scene, kSize, kSize);
  picture.show(view);
  std::vector<glm::ivec2> row;
  for (int x = 0; x < kSize; ++x) row.emplace_back(x, kSize / 2);
  const double critical = std::asin(1.0 / static_cast<double>(ior)), tangent = std::tan(0.5 * glm::radians(110.0));
  int total = 0, passing = 0;
  for (const Explanation& e : picture.renderer->explain(row, kSize, kSize)) {
    ASSERT_TRUE(e.glass) << e.x;
    EXPECT_TRUE(e.glass->back);
    const double across = (2.0 * (e.x + 0.5) / kSize - 1.0) * tangent, angle = std::atan(std::abs(across));
    if (std::abs(std::abs(across) - std::tan(critical)) < 2.0 * tangent / kSize) continue;
    // The face is 0.26 to either side, 0.12 away; beyond are the sides, met at the complement.
    if (0.12 * std::abs(across) > 0.25) continue;
    EXPECT_EQ(e.glass->reflectance >= 1.0f, angle > critical) << "pixel " << e.x;
    (angle > critical ? total : passing) += 1;
    ASSERT_TRUE(e.rendered);
    EXPECT_LT(*relativeDifference(e), 0.01f) << "pixel " << e.x << ": what is drawn is what is explained";
    if (angle <= critical) continue;
    EXPECT_EQ(e.glass->light(), glm::vec3(0.0f));
  }
  std::printf("  critical angle %.2f degrees: %d pixels pass light, %d are totally reflected\n", glm::degrees(critical),
              passing, total);
  EXPECT_GT(passing, 20);
  EXPECT_GT(total, 20);
}

TEST(Glass, APaneBendsNothingAndReflectsWithBothFaces) {
  const Measured m = measure("pane", "pane", 0.0f, 1.5f, {GlassForm::Automatic});
  const GlassError& error = m.forms.at(GlassForm::Automatic);
  std::printf("  pane: RMSE %.4f over %d pixels, largest %.3f\n", error.rmse, error.pixels, error.largest);
  EXPECT_GT(error.pixels, 2000);
  EXPECT_LT(error.rmse, 0.012);
  const Measured rough = measure("pane", "pane", 0.5f, 1.5f, {GlassForm::Automatic});
  std::printf("  pane, roughness 0.5: RMSE %.4f\n", rough.forms.at(GlassForm::Automatic).rmse);
  EXPECT_LT(rough.forms.at(GlassForm::Automatic).rmse, 0.05);
}

// In surroundings of one radiance clear glass shows nothing but that, whatever its form and roughness.
TEST(Glass, NoLightIsLostInAWhiteFurnace) {
  Scene scene = glassScene();
  for (const char* wall : {"wall east", "wall west", "ceiling", "floor", "wall south", "wall north", "plinth 1",
                           "plinth 2", "plinth 3", "plinth 4", "plinth 5"}) {
    scene.objects[wall].visible = false;
  }
  scene.probes.clear();
  scene.sky = SkyColor{{0.5f, 0.5f, 0.5f}};
  for (const std::string& object : kSolids) scene.materials[object].attenuationDistance = 0.0f;
  ScenePicture picture(scene, 160, 120);
  for (const float roughness : {0.0f, 0.4f}) {
    for (const GlassForm form :
         {GlassForm::OnePass, GlassForm::TwoPass, GlassForm::TwoInterface, GlassForm::Automatic}) {
      for (const std::string& object : kSolids) {
        picture.scene.materials[object].roughness = roughness;
        picture.scene.materials[object].glass = form;
      }
      picture.show(cameraNamed(scene, "main"));
      const ImageRgbaF image = picture.linear(1);
      float low = 1.0f, high = 0.0f;
      for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (i % 4 == 3) continue;
        low = std::min(low, image.pixels[i]);
        high = std::max(high, image.pixels[i]);
      }
      EXPECT_GT(low, 0.495f) << kForms[static_cast<int>(form)] << " " << roughness;
      EXPECT_LT(high, 0.505f) << kForms[static_cast<int>(form)] << " " << roughness;
    }
  }
}

TEST(Glass, IsExplainedAsItIsDrawn) {
  Scene scene = glassScene();
  ScenePicture picture(scene, kWidth, kHeight);
  constexpr double kRounding = 1.0e-3;
  double worst = 0.0;
  int within = 0, beyond = 0, glass = 0;
  for (const GlassForm form : {GlassForm::OnePass, GlassForm::TwoPass, GlassForm::TwoInterface}) {
    for (const char* camera : {"main", "ball", "block", "cup", "pane", "inside ball", "inside block"}) {
      for (const std::string& object : kSolids) {
        picture.scene.materials[object].glass = form;
        picture.scene.materials[object].roughness = object == "block" ? 0.25f : 0.0f;
      }
      picture.show(cameraNamed(scene, camera));
      std::vector<glm::ivec2> places;
      for (int y = 4; y < kHeight; y += 9) {
        for (int x = 4; x < kWidth; x += 9) places.emplace_back(x, y);
      }
      for (const Explanation& e : picture.renderer->explain(places, kWidth, kHeight)) {
        if (!e.hit || !e.rendered) continue;
        glass += e.glass ? 1 : 0;
        const double off = static_cast<double>(*relativeDifference(e));
        // Which face of the shell a ray leaves by is decided by comparing: at an edge rounding may decide otherwise.
        (off > kRounding ? beyond : within) += 1;
        if (off <= kRounding) worst = std::max(worst, off);
      }
    }
  }
  std::printf("  %d pixels compared, %d of them glass: worst difference %.5f of the brightest texel, %d beyond %.3f\n",
              within + beyond, glass, worst, beyond, kRounding);
  EXPECT_GT(glass, 1000);
  EXPECT_LE(beyond, glass / 500);
}

TEST(Glass, AProbeThatSeesWhatItIsLookedThroughIsNamed) {
  ScenePicture picture(glassScene(), 64, 48);
  picture.show(cameraNamed(picture.scene, "ball"));
  EXPECT_TRUE(picture.renderer->remarks().empty());
  std::vector<std::string>& hides = picture.scene.probes[*findProbe(picture.scene, "ball")].hides;
  hides.erase(std::find(hides.begin(), hides.end(), "ball"));
  picture.show(cameraNamed(picture.scene, "ball"));
  ASSERT_EQ(picture.renderer->remarks().size(), 1u);
  EXPECT_EQ(picture.renderer->remarks().front().rfind("probes.ball.hides: the probe sees \"ball\"", 0), 0u)
      << picture.renderer->remarks().front();
}

// Without glass nothing of it is compiled, drawn or counted; with it, its passes are.
TEST(Glass, CostsNothingWhereThereIsNone) {
  ScenePicture picture = ScenePicture::fromFile("scenes/six-faces.boxprobe.json", 96, 96);
  const Camera view = picture.scene.cameras.front();
  picture.show(view);
  const ImageRgba8 before = picture.display();
  const std::uint64_t programs = picture.renderer->counters().programsCompiled;
  EXPECT_EQ(picture.renderer->counters().glassDraws, 0u);
  EXPECT_EQ(picture.renderer->counters().glassPasses, 0u);
  picture.scene.materials["ball"].transmission = 1.0f;
  picture.scene.materials["ball"].metallic = 0.0f;
  picture.scene.materials["ball"].thickness = 0.5f;
  picture.show(view);
  const ImageRgba8 glass = picture.display();
  EXPECT_EQ(picture.renderer->counters().glassDraws, 1u);
  EXPECT_EQ(picture.renderer->counters().glassPasses, 1u);
  picture.scene.materials["ball"].glass = GlassForm::TwoPass;
  picture.show(view);
  picture.display();
  EXPECT_EQ(picture.renderer->counters().glassDraws, 1u);
  EXPECT_EQ(picture.renderer->counters().glassPasses, 2u);
  EXPECT_GT(picture.renderer->counters().programsCompiled, programs);
  const std::uint64_t compiled = picture.renderer->counters().programsCompiled;
  picture.scene.materials.erase("ball");
  picture.show(view);
  EXPECT_EQ(picture.display().pixels, before.pixels);
  EXPECT_EQ(picture.renderer->counters().programsCompiled, compiled) << "the program of before, and no other";
  EXPECT_EQ(picture.renderer->counters().glassDraws, 0u);
  EXPECT_NE(glass.pixels, before.pixels);
}

}  // namespace
