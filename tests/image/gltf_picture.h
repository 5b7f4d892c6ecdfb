// A small glTF file, made in a test, opened as the program opens it and drawn: a square of 2 x 2 units that fills the
// picture, seen along -Z in parallel projection.
#pragma once

#include <array>
#include <glm/gtc/constants.hpp>
#include <memory>

#include "app/session/load_scene.h"
#include "filters/io/image/image_file.h"
#include "filters/reference/light/reference_scene.h"
#include "tests/support/scene_picture.h"
#include "tests/unit/io_glb_builder.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe::test {

class GltfPicture : public TemporaryFolder {
 protected:
  using Json = nlohmann::json;
  static constexpr int kSize = 64;
  using Corners = std::vector<float>;  // u, v of lower left, lower right, upper right, upper left

  GlbBuilder glb;

  /// Attributes of the square, with texture coordinates that put a picture upright on it.
  Json square(const Corners& uv = {0, 1, 1, 1, 1, 0, 0, 0}, float z = 0.0f) {
    return {{"POSITION", glb.floats("VEC3", 3, {-1, -1, z, 1, -1, z, 1, 1, z, -1, 1, z})},
            {"NORMAL", glb.floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1})},
            {"TEXCOORD_0", glb.floats("VEC2", 2, uv)}};
  }
  /// A node that shows it in a material; returns the node.
  int show(const Json& attributes, const Json& material, const Json& node = Json::object()) {
    glb.json["materials"].push_back(material);
    const int indices =
        glb.accessor(glb.view(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}), GlbBuilder::UShort, "SCALAR", 6);
    Json placed = node;
    placed["mesh"] = glb.mesh({{"attributes", attributes},
                               {"indices", indices},
                               {"material", static_cast<int>(glb.json["materials"].size()) - 1}});
    return glb.node(placed);
  }
  /// A texture of these RGBA texels, rows from the top; returns its index.
  int texture(int width, const std::vector<std::uint8_t>& rgba, const Json& sampler = Json::object()) {
    const ImageRgba8 texels{width, static_cast<int>(rgba.size()) / 4 / width, rgba, "t"};
    savePng(file("t.png"), texels);
    const std::string bytes = read("t.png");
    glb.json["images"].push_back(
        {{"bufferView", glb.view(std::vector<char>(bytes.begin(), bytes.end()))}, {"mimeType", "image/png"}});
    glb.json["samplers"].push_back(sampler);
    glb.json["textures"].push_back({{"source", static_cast<int>(glb.json["images"].size()) - 1},
                                    {"sampler", static_cast<int>(glb.json["samplers"].size()) - 1}});
    return static_cast<int>(glb.json["textures"].size()) - 1;
  }
  int oneColor(std::array<std::uint8_t, 4> rgba) { return texture(1, {rgba[0], rgba[1], rgba[2], rgba[3]}); }

  static Json unlit() { return {{"extensions", {{"KHR_materials_unlit", Json::object()}}}}; }
  static Json merged(Json a, const Json& b) {
    a.merge_patch(b);
    return a;
  }
  /// IEC 61966-2-1.
  static float linear(int srgb) {
    const double c = srgb / 255.0;
    return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }

  void draw() { drawFile(write("model.glb", glb.glb())); }
  void drawFile(const std::string& path) {
    LoadedScene loaded = loadScene(path);
    warnings = loaded.warnings;
    model = loaded.models.front();
    loaded.scene.sky = sky;
    picture = std::make_unique<ScenePicture>(loaded.scene, kSize, kSize);
    picture->renderer->setModels(loaded.models);
    Camera camera;
    camera.position = middle + glm::dvec3(0.0, 0.0, 5.0);
    camera.target = middle;
    camera.parallelHeight = 2.0;
    if (ownCamera) camera = loaded.scene.cameras.front();
    picture->renderer->sync(picture->scene, Changes::all());
    picture->renderer->applyCamera(camera);
    picture->renderer->setProbesEnabled(probes);
    picture->renderer->finishWork();
    ASSERT_EQ(picture->renderer->error(), "");
    image = picture->linear(1);
    ASSERT_EQ(picture->renderer->error(), "");
    keepPicture(image, ::testing::UnitTest::GetInstance()->current_test_info()->name());
  }
  glm::vec4 pixel(int x, int y) const {
    const float* p = &image.pixels[4 * static_cast<std::size_t>(y * kSize + x)];
    return {p[0], p[1], p[2], p[3]};
  }
  /// Where pixel centres lie on the square, 0 to 1 from the upper left.
  static double share(int i) { return (i + 0.5) / kSize; }
  void expectPixel(int x, int y, const glm::vec3& expected, float within = 1e-5f) const {
    const glm::vec4 p = pixel(x, y);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(p[i], expected[i], within) << x << ", " << y << " channel " << i;
  }
  /// The ray tracer has the same of this file, which shows nothing but unlit materials.
  void expectTracedAlike() const {
    const ReferenceScene reference(picture->scene, {model}, nullptr);
    int compared = 0;
    for (int y = 2; y < kSize; y += 7) {
      for (int x = 2; x < kSize; x += 7) {
        const glm::dvec3 eye(2.0 * share(x) - 1.0, 1.0 - 2.0 * share(y), 5.0);
        const glm::dvec3 traced = reference.seenFrom(eye, {0.0, 0.0, -1.0}, RaySees::Picture);
        // Where a texel ends, rounding decides.
        const glm::vec4 drawn = pixel(x, y);
        bool even = true;
        for (int i = 0; i < 3; ++i) even = even && pixel(x - 1, y)[i] == drawn[i] && pixel(x + 1, y)[i] == drawn[i];
        if (!even) continue;
        ++compared;
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(traced[i], drawn[i], 1e-4) << "traced " << x << ", " << y;
      }
    }
    EXPECT_GT(compared, 20);
  }
  SurfacePoint surfaceAt(int x, int y) const { return picture->renderer->explain(x, y, kSize, kSize).surface; }

  Sky sky = SkyColor{{0.0f, 0.0f, 0.0f}};
  glm::dvec3 middle{0.0};  ///< of what is drawn
  bool ownCamera = false;  ///< look through the file's
  bool probes = false;
  std::unique_ptr<ScenePicture> picture;
  std::shared_ptr<const Model> model;
  std::vector<std::string> warnings;
  ImageRgbaF image;
};

}  // namespace boxprobe::test
