// The splice against the shader VTK really writes: every kind of material, with lights and without, finds its anchors
// and compiles; a shader without an anchor is reported by name and left alone.
#include <gtest/gtest.h>

#include <cmath>

#include "filters/vtk/surface/vtk_pbr_splice.h"
#include "tests/image/quad_world.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

Model quadModel(const Material& material, bool uv) {
  Model model;
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  if (uv) mesh.uv = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.material = 0;
  model.meshes.push_back(mesh);
  model.materials.push_back(material);
  model.instances.push_back({"quad", 0, glm::dmat4(1.0)});
  return model;
}

Scene quadScene(int lights) {
  Scene scene;
  scene.models.push_back({"quad", {}, {}, 1.0});
  scene.sky = SkyColor{{0.25f, 0.5f, 0.75f}};
  for (int i = 0; i < lights; ++i) {
    Light light;
    light.type = i % 2 == 0 ? LightType::Directional : LightType::Point;
    light.direction = {0, 0, -1};
    light.position = {0, 0, 2};
    light.intensity = 0.0f;
    scene.lights.push_back(light);
  }
  return scene;
}

glm::vec3 centreOf(const Model& model, Scene scene, bool parallel = false) {
  ScenePicture picture(std::move(scene), 33, 33);
  picture.renderer->setModels({std::make_shared<Model>(model)});
  Camera camera;
  camera.position = {0, 0, 4};
  camera.target = {0, 0, 0};
  camera.verticalFovDegrees = 20.0;
  picture.renderer->sync(picture.scene, Changes::all());
  picture.renderer->applyCamera(camera);
  if (parallel) picture.setParallel(1.0);
  picture.renderer->finishWork();
  const ImageRgbaF image = picture.linear(1);
  EXPECT_EQ(picture.renderer->error(), "");
  const float* c = &image.pixels[(std::size_t{16} * 33 + 16) * 4];
  EXPECT_EQ(c[3], 1.0f);
  return {c[0], c[1], c[2]};
}

TEST(Splice, EveryKindOfMaterialIsLitBySky) {
  auto white = std::make_shared<ImageRgba8>();
  white->width = white->height = 2;
  white->pixels.assign(16, 255);
  for (int lights = 0; lights <= 3; ++lights) {
    for (int kind = 0; kind < 8; ++kind) {
      const bool textured = (kind & 1) != 0, metal = (kind & 2) != 0, coat = (kind & 4) != 0;
      Material material;
      material.name = "m";
      material.metallic = metal ? 1.0f : 0.0f;
      material.roughness = 0.5f;
      material.coat = coat ? 0.8f : 0.0f;
      material.coatRoughness = 0.2f;
      if (textured) {
        material.baseColorTexture.image = white;
        material.metallicRoughnessTexture.image = white;
        material.emissiveTexture.image = white;
      }
      const glm::vec3 c = centreOf(quadModel(material, textured), quadScene(lights));
      // A white surface under an even sky of radiance L shows L, less what single scattering and the coat's absorption
      // lose. VTK's own coat keeps the base layer unattenuated, so with a coat it shows a little more.
      for (int i = 0; i < 3; ++i) {
        const float sky = 0.25f * static_cast<float>(i + 1);
        EXPECT_GT(c[i], 0.80f * sky) << "lights " << lights << " kind " << kind;
        EXPECT_LT(c[i], 1.10f * sky) << "lights " << lights << " kind " << kind;
      }
    }
  }
}

TEST(Splice, UnlitAndEmissionWithoutATexture) {
  Material unlit;
  unlit.unlit = true;
  unlit.baseColor = {0.1f, 0.2f, 0.3f, 1.0f};
  const glm::vec3 a = centreOf(quadModel(unlit, false), quadScene(1));
  EXPECT_NEAR(a.x, 0.1f, 1e-6f);
  EXPECT_NEAR(a.z, 0.3f, 1e-6f);

  Material lamp;
  lamp.baseColor = {0.0f, 0.0f, 0.0f, 1.0f};
  lamp.metallic = 1.0f;  // black metal: no diffuse, no specular at normal incidence
  lamp.roughness = 1.0f;
  lamp.emissive = {7.0f, 5.0f, 3.0f};
  Scene dark = quadScene(1);
  dark.sky = SkyColor{{0.0f, 0.0f, 0.0f}};
  const glm::vec3 b = centreOf(quadModel(lamp, false), dark);
  EXPECT_NEAR(b.x, 7.0f, 1e-5f);
  EXPECT_NEAR(b.z, 3.0f, 1e-5f);
}

// Under parallel projection every pixel looks along one direction; a flat mirror then reflects one direction of the
// sky.
TEST(Splice, ParallelProjectionHasOneViewVector) {
  Material mirror;
  mirror.roughness = 0.0f;
  Scene scene = quadScene(0);
  scene.sky = SkyGradient{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const glm::vec3 c = centreOf(quadModel(mirror, false), scene, true);
  EXPECT_NEAR(c.y, 1.0f, 0.03f);  // reflects the horizon behind the camera
}

// Squares whose normals face the eye, run along it, face away, have no length, or all of these at their corners: as
// interpolation and normal maps make them. From both sides, at the ends of roughness, with coat and with lights.
TEST(Splice, EveryPixelIsANumberWhateverItsNormal) {
  constexpr int kSquares = 6;
  const glm::vec3 normals[kSquares][2] = {
      {{0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 1.0f}},   {{1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}},
      {{0.0f, 0.0f, -1.0f}, {0.0f, 0.0f, -1.0f}}, {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}},
      {{0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, -1.0f}},  {{1.0f, 0.0f, 1.0e-7f}, {0.0f, 1.0f, -1.0e-7f}}};
  Model model;
  for (int kind = 0; kind < 8; ++kind) {
    Material material;
    material.metallic = (kind & 1) != 0 ? 1.0f : 0.0f;
    material.roughness = (kind & 2) != 0 ? 1.0f : 0.0f;
    material.coat = (kind & 4) != 0 ? 1.0f : 0.0f;
    material.doubleSided = true;
    for (int i = 0; i < kSquares; ++i) {
      addSquare(model, "square " + std::to_string(kSquares * kind + i), {-1.0f + 0.4f * i, -0.7f + 0.2f * kind, 0.0f},
                {0.18f, 0.0f, 0.0f}, {0.0f, 0.09f, 0.0f}, material);
      std::vector<glm::vec3>& corner = model.meshes.back().normals;
      for (std::size_t c = 0; c < corner.size(); ++c) corner[c] = normals[i][c % 2];
    }
  }
  for (const char* technique : {"box", "box+hdrp", "sphere+footprint1", "box+raytraced"}) {
    Scene scene = quadScene(2);
    for (Light& light : scene.lights) light.intensity = 3.0f;
    scene.probes.push_back(cubeProbe("probe", {0.0, 0.0, 0.5}, 1.5, 16));
    scene.probes.back().technique = technique;
    ScenePicture picture(std::move(scene), 96, 64);
    picture.renderer->setModels({std::make_shared<Model>(model)});
    picture.renderer->sync(picture.scene, Changes::all());
    picture.renderer->finishWork();
    ASSERT_EQ(picture.renderer->error(), "");
    // In front, behind, and along the squares.
    for (const glm::dvec3& eye : {glm::dvec3(0, 0, 1.4), glm::dvec3(0, 0, -0.9), glm::dvec3(1.4, 0, 0.05)}) {
      Camera camera;
      camera.position = eye;
      camera.target = {0, 0, 0};
      picture.renderer->applyCamera(camera);
      const ImageRgbaF image = picture.linear(1);
      std::size_t notFinite = 0, drawn = 0;
      for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        notFinite += std::isfinite(image.pixels[i]) ? 0 : 1;
        drawn += i % 4 == 0 && image.pixels[i] != 0.25f ? 1 : 0;  // unlike the sky
      }
      EXPECT_EQ(notFinite, 0u) << technique << " from " << eye.x << " " << eye.z;
      EXPECT_GT(drawn, 100u) << technique << " from " << eye.x << " " << eye.z;
    }
  }
}

TEST(Splice, MissingAnchorIsNamedAndNothingIsChanged) {
  ProbeBinding binding;
  binding.lighting = Lighting::Probes;
  const std::string lines = "void main()\n{\n  gl_FragData[0] = vec4(1.0);\n}\n";
  const SurfaceMaterial surface;
  ShaderSources sources{"void main()\n{\n}\n", {}, lines};
  const SurfaceProgram program{binding, &surface, SurfaceOutput::Picture, false};
  EXPECT_EQ(splicePbr(sources, program, false).failure, "");
  EXPECT_EQ(sources.fragment, lines) << "not a physically based shader: left alone";

  const std::string anchors[] = {"float V = V_SmithCorrelated(NdV, NdL, roughness);",
                                 "float d = (NdH * a2 - NdH) * NdH + 1.0;",
                                 "vec3 V = normalize(-vertexVC.xyz);",
                                 "vec3 emissiveColor = vec3(0.0);",
                                 "vec3 irradiance = vec3(0.0);",
                                 "vec3 prefilteredSpecularColor = vec3(0.0);",
                                 "vec2 brdf = vec2(0.0, 0.0);",
                                 "vec3 albedo = diffuseColor;",
                                 "float roughness = roughnessUniform;",
                                 "float metallic = metallicUniform;",
                                 "float ao = 1.0;",
                                 "//VTK::Normal::Impl",
                                 "color += Lo;\n  color = mix(color, color * ao, aoStrengthUniform);",
                                 "color = pow(color, vec3(1.0/2.2));"};
  for (const std::string& left : anchors) {
    std::string text = "void main()\n{\n";
    for (const std::string& anchor : anchors) {
      if (anchor != left) text += "  " + anchor + "\n";
    }
    text += "  vec3 specularBrdf = F0 * brdf.r + F90 * brdf.g;\n}\n";
    const std::string vertices = "void main()\n{\n}\n";
    ShaderSources spliced{vertices, {}, text};
    const std::string failure = splicePbr(spliced, program, true).failure;
    // In one line, whatever the anchor has.
    EXPECT_NE(failure.find(left.substr(0, left.find('\n'))), std::string::npos) << failure;
    EXPECT_EQ(failure.find('\n'), std::string::npos) << failure;
    EXPECT_EQ(failure.find("VTK 9."), 0u) << failure;
    EXPECT_EQ(spliced.fragment, text);
    EXPECT_EQ(spliced.vertex, vertices);
  }
}

}  // namespace
