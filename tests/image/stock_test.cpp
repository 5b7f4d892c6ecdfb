// The infinite technique, with the sky as its probe, against VTK's own image-based lighting given the same maps: the
// splice adds nothing and loses nothing. VTK's textures are replaced by ours (radiance chain, split-sum table) or by an
// irradiance cube evaluated from our harmonics; its roughness-to-level line by ours, because the chain is baked for
// that.
#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLightCollection.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRIrradianceTexture.h>
#include <vtkPBRLUTTexture.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersionMacros.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "filters/math/published/published_math.h"
#include "filters/math/shared/shared_math.h"
#include "filters/vtk/gl/software_driver.h"
#include "filters/vtk/surface/vtkProbeActor.h"
#include "tests/support/scene_picture.h"
#include "tests/support/sphere_mesh.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

// VTK's image-based-lighting textures with a content of ours: Load computes nothing.
template <typename Base>
class Given : public Base {
 public:
  static Given* New() {
    auto* object = new Given;
    object->InitializeObjectBase();
    return object;
  }
  void Give(vtkOpenGLRenderWindow* window, unsigned int handle, unsigned int target, int levels) {
    this->TextureObject->SetContext(window);
    this->TextureObject->AssignToExistingTexture(handle, target);
    this->TextureObject->SetMinificationFilter(levels == 1 ? vtkTextureObject::Linear
                                                           : vtkTextureObject::LinearMipmapLinear);
    this->TextureObject->SetMagnificationFilter(vtkTextureObject::Linear);
    this->TextureObject->SetWrapS(vtkTextureObject::ClampToEdge);
    this->TextureObject->SetWrapT(vtkTextureObject::ClampToEdge);
    this->TextureObject->SetWrapR(vtkTextureObject::ClampToEdge);
    this->TextureObject->SetMaxLevel(levels - 1);
  }
  void Load(vtkRenderer*) override { this->TextureObject->Activate(); }

 protected:
  Given() { this->TextureObject = vtkTextureObject::New(); }
  ~Given() override = default;
};
using GivenPrefilter = Given<vtkPBRPrefilterTexture>;
using GivenIrradiance = Given<vtkPBRIrradianceTexture>;
using GivenTable = Given<vtkPBRLUTTexture>;

class GivenRenderer : public vtkOpenGLRenderer {
 public:
  static GivenRenderer* New() { VTK_STANDARD_NEW_BODY(GivenRenderer); }
  GivenPrefilter* Prefilter = GivenPrefilter::New();
  GivenIrradiance* Irradiance = GivenIrradiance::New();
  GivenTable* Table = GivenTable::New();

 protected:
  GivenRenderer() {
    this->EnvMapPrefiltered = this->Prefilter;
    this->EnvMapIrradiance = this->Irradiance;
    this->EnvMapLookupTable = this->Table;
  }
};

// VTK 9.1's split sum: the masking that is most often printed.
constexpr int kTableColumns = 128, kTableRows = 64;
std::vector<glm::vec2> vtkTable() {
  std::vector<glm::vec2> table;
  for (int row = 0; row < kTableRows; ++row) {
    for (int column = 0; column < kTableColumns; ++column) {
      table.push_back(shading::publishedSplitSum((static_cast<float>(column) + 0.5f) / kTableColumns,
                                                 (static_cast<float>(row) + 0.5f) / kTableRows));
    }
  }
  return table;
}

const std::vector<std::uint8_t> kChecker = {255, 255, 255, 255, 90,  120, 160, 255,
                                            200, 80,  40,  255, 255, 255, 255, 255};

/// The same picture as a VTK texture, set up as ours are.
vtkSmartPointer<vtkTexture> stockTexture(bool srgb) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(2, 2, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  std::copy(kChecker.begin(), kChecker.end(), static_cast<std::uint8_t*>(data->GetScalarPointer()));
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(data);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->SetMaximumAnisotropicFiltering(textureAnisotropy());
  texture->SetUseSRGBColorSpace(srgb);
  texture->SetColorModeToDirectScalars();
  return texture;
}

// Rows: metal, dielectric, metal under a clear coat, dielectric with textures; columns: roughness 0 to 1.
Model spheres() {
  Model model;
  auto checker = std::make_shared<ImageRgba8>();
  checker->width = checker->height = 2;
  checker->pixels = kChecker;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 5; ++column) {
      Material material;
      material.name = "m" + std::to_string(model.materials.size());
      material.baseColor = {0.9f, 0.7f, 0.5f, 1.0f};
      material.metallic = row == 0 || row == 2 ? 1.0f : 0.0f;
      material.roughness = 0.25f * static_cast<float>(column);
      if (row == 2) material.coat = 0.7f;
      if (row == 2) material.coatRoughness = 0.3f;
      if (row == 3) material.baseColorTexture.image = material.metallicRoughnessTexture.image = checker;
      Mesh mesh = sphereMesh(0.45f, 32, 64);
      mesh.material = static_cast<int>(model.materials.size());
      model.materials.push_back(material);
      model.meshes.push_back(std::move(mesh));
      model.instances.push_back({"s", static_cast<int>(model.meshes.size()) - 1,
                                 glm::translate(glm::dmat4(1.0), glm::dvec3(column - 2.0, 1.5 - row, 0.0))});
    }
  }
  return model;
}

TEST(Stock, InfiniteEqualsVtksOwnLightingWithTheSameMaps) {
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 1)
  GTEST_SKIP() << "from 9.6.1 on VTK's own image-based lighting adds multiple scattering by a form of its own";
#endif
  Scene scene;
  scene.lamps = LampForm::InMap;  // diffuse light of nine coefficients, as VTK has it
  scene.models.push_back({"spheres", {}, {}, 1.0});
  scene.sky = SkyGradient{{0.15f, 0.3f, 0.9f}, {0.9f, 0.8f, 0.7f}, {0.25f, 0.15f, 0.05f}};
  Probe probe;
  probe.technique = "infinite";
  probe.box = Box{glm::dvec3(-50.0), glm::dvec3(50.0)};
  scene.probes.push_back(probe);
  scene.objects["s"].seenByProbes = false;  // the probe sees nothing but sky
  Light sun;
  sun.direction = {-0.3, -1.0, -0.6};
  sun.intensity = 0.5f;
  scene.lights.push_back(sun);

  ScenePicture picture(scene, 640, 512);
  picture.renderer->setModels({std::make_shared<Model>(spheres())});
  Camera camera;
  camera.position = {0, 0, 8};
  camera.target = {0, 0, 0};
  camera.verticalFovDegrees = 30.0;
  picture.renderer->sync(scene, Changes::all());
  picture.renderer->applyCamera(camera);
  picture.renderer->finishWork();
  const std::vector<glm::vec2> values = vtkTable();
  picture.renderer->useVtkLighting(kTableColumns, kTableRows, values);
  const ImageRgba8 ours = picture.display();
  keepPicture(ours, "stock_ours");
  const ImageRgbaF coverage = picture.linear(1);

  vtkRenderer* renderer = picture.renderer->renderer();
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  auto* lit = vtkProbeActor::SafeDownCast(actors->GetNextActor());
  const ProbeMaps& maps = *lit->GetPass()->GetBinding()->probes.at(0)->maps;

  vtkNew<GivenRenderer> stock;
  stock->Prefilter->Give(picture.window, maps.radiance.handle(), GL_TEXTURE_CUBE_MAP, maps.radiance.levels());
  stock->Prefilter->SetPrefilterLevels(static_cast<unsigned int>(maps.radiance.levels()));
  CubeTexture cube;
  constexpr int kFace = 64;
  cube.allocate(kFace, 1, GL_RGBA16F);
  const ShCoefficients& sh = maps.irradiance;
  for (int face = 0; face < 6; ++face) {
    std::vector<float> texels;
    for (int i = 0; i < kFace * kFace; ++i) {
      const int column = i % kFace, row = i / kFace;
      const float s = 2.0f * (static_cast<float>(column) + 0.5f) / kFace - 1.0f,
                  t = 2.0f * (static_cast<float>(row) + 0.5f) / kFace - 1.0f;
      const glm::vec3 n = glm::normalize(shading::cubeDirection(face, s, t));
      const glm::vec3 e = shading::shIrradiance(n, sh[0], sh[1], sh[2], sh[3], sh[4], sh[5], sh[6], sh[7], sh[8]);
      texels.insert(texels.end(), {e.x, e.y, e.z, 1.0f});
    }
    cube.writeFace(face, 0, texels);
  }
  stock->Irradiance->Give(picture.window, cube.handle(), GL_TEXTURE_CUBE_MAP, 1);
  GLuint tableTexture = 0;
  glGenTextures(1, &tableTexture);
  glBindTexture(GL_TEXTURE_2D, tableTexture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RG16F, kTableColumns, kTableRows, 0, GL_RG, GL_FLOAT, values.data());
  glBindTexture(GL_TEXTURE_2D, 0);
  stock->Table->Give(picture.window, tableTexture, GL_TEXTURE_2D, 1);

  // The same actors under VTK's own mapper.
  stock->UseImageBasedLightingOn();
  stock->UseSphericalHarmonicsOff();
  vtkNew<vtkTexture> environment;  // never read, but without one VTK takes image-based lighting for off
  environment->CubeMapOn();
  stock->SetEnvironmentTexture(environment);
  stock->AutomaticLightCreationOff();
  stock->SetActiveCamera(renderer->GetActiveCamera());
  renderer->GetLights()->InitTraversal();
  stock->AddLight(renderer->GetLights()->GetNextItem());
  actors->InitTraversal();
  int copied = 0;
  while (vtkActor* actor = actors->GetNextActor()) {
    vtkNew<vtkOpenGLPolyDataMapper> plain;
    vtkNew<vtkPolyData> data;
    data->ShallowCopy(actor->GetMapper()->GetInputDataObject(0, 0));
    data->GetPointData()->SetTCoords(data->GetPointData()->GetArray("bpUv0"));
    plain->SetInputData(data);
    plain->ScalarVisibilityOff();
    vtkNew<vtkActor> copy;
    copy->SetMapper(plain);
    copy->GetProperty()->DeepCopy(actor->GetProperty());
    if (copied++ >= 15) {  // the row with textures
      copy->GetProperty()->SetBaseColorTexture(stockTexture(true));
      copy->GetProperty()->SetORMTexture(stockTexture(false));
      copy->GetProperty()->SetOcclusionStrength(0.0);
    }
    copy->SetUserMatrix(actor->GetUserMatrix());
    for (const std::string name : {"roughness", "coatRoughness"}) {
      std::string lookup = name == "roughness" ? "worldReflect" : "coatWorldReflect";
      lookup.append(", log2(1.0 + ").append(name).append(" * ").append(name);
      lookup.append(" * (exp2(prefilterMaxLevel) - 1.0))");
      copy->GetShaderProperty()->AddFragmentShaderReplacement(
          name == "roughness" ? "worldReflect, roughness * prefilterMaxLevel"
                              : "coatWorldReflect, coatRoughness * prefilterMaxLevel",
          false, lookup, false);
    }
    stock->AddActor(copy);
  }
  picture.window->RemoveRenderer(renderer);
  picture.window->AddRenderer(stock);
  picture.window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  picture.window->GetPixelData(0, 0, 639, 511, 1, pixels, 0);
  ImageRgba8 theirs{640, 512, std::vector<std::uint8_t>(std::size_t{640} * 512 * 4, 255), {}};
  for (int i = 0; i < 640 * 512; ++i) {
    const int from = (511 - i / 640) * 640 + i % 640;
    std::uint8_t* to = &theirs.pixels[4 * static_cast<std::size_t>(i)];
    for (int c = 0; c < 3; ++c) to[c] = pixels->GetValue(3 * from + c);
  }
  keepPicture(theirs, "stock_theirs");
  picture.window->RemoveRenderer(stock);
  picture.window->AddRenderer(renderer);

  int worst = 0, different = 0, compared = 0;
  std::vector<glm::ivec2> beyond;
  for (int y = 0; y < 512; ++y) {
    for (int x = 0; x < 640; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * 640 + static_cast<std::size_t>(x);
      if (coverage.pixels[4 * i + 3] < 1.0f) continue;
      ++compared;
      int d = 0;
      for (int c = 0; c < 3; ++c)
        d = std::max(d, std::abs(ours.pixels[4 * i + static_cast<std::size_t>(c)] -
                                 pixels->GetValue(((511 - y) * 640 + x) * 3 + c)));
      worst = std::max(worst, d);
      different += d > 0;
      if (d > 1) beyond.emplace_back(x, y);
    }
  }
  std::printf("  %d of %d pixels differ, %zu by more than 1/255, by at most %d/255\n", different, compared,
              beyond.size(), worst);
  EXPECT_GT(compared, 640 * 512 / 4);
  // Only where a shading normal turns away from the eye: VTK then reflects from below the surface, and we do not.
  for (const Explanation& e : picture.renderer->explain(beyond, 640, 512)) {
    std::printf("  N.V of %d, %d: %g\n", e.x, e.y,
                static_cast<double>(glm::dot(e.surface.normalWorld, e.surface.viewWorld)));
    EXPECT_LT(glm::dot(e.surface.normalWorld, e.surface.viewWorld), 1.0e-3f) << e.x << ", " << e.y;
  }
  EXPECT_LE(worst, 2);
  EXPECT_LE(beyond.size(), 20u);
  glDeleteTextures(1, &tableTexture);
}

}  // namespace
