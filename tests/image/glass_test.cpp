// Glass as drawn against glass ray traced, object by object and form by form, from outside and from within; that an
// index of 1 is not there, that the critical angle is where it belongs, and what a scene without glass pays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <map>

#include "filters/core/explanation_sections.h"
#include "filters/io/model_file.h"
#include "filters/reference/reference_scene.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 200, kHeight = 160;
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
  const ReferencePicture truth = traced(reference, view, roughness > 0.0f ? 128 : 4);
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

TEST(Glass, FormsAgainstTheRayTracedObject) {
  const std::vector<GlassForm> forms = {GlassForm::OnePass, GlassForm::TwoPass, GlassForm::TwoInterface,
                                        GlassForm::Automatic};
  std::printf("  RMSE of linear radiance    one-pass  two-pass  two-interface  auto\n");
  for (const float roughness : {0.0f, 0.3f}) {
    for (const std::string& object : kSolids) {
      const Measured m = measure(object, object, roughness, 1.5f, forms);
      std::printf("  %-6s roughness %.1f (%5d)    %.4f    %.4f    %.4f         %.4f\n", object.c_str(),
                  static_cast<double>(roughness), m.forms.at(GlassForm::OnePass).pixels,
                  m.forms.at(GlassForm::OnePass).rmse, m.forms.at(GlassForm::TwoPass).rmse,
                  m.forms.at(GlassForm::TwoInterface).rmse, m.forms.at(GlassForm::Automatic).rmse);
      for (const auto& [form, error] : m.forms) {
        EXPECT_TRUE(error.finite) << object << " " << kForms[static_cast<int>(form)];
        EXPECT_GT(error.pixels, 1000) << object;
      }
    }
  }
}

}  // namespace
