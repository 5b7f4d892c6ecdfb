// See stock_renderer.h.
#include "tests/bench/stock_renderer.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRIrradianceTexture.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSkybox.h>
#include <vtkTexture.h>

#include <glm/geometric.hpp>

#include "filters/math/shared/shared_math.h"
#include "filters/vtk/draw/plain_surface.h"
#include "filters/vtk/surface/vtkProbeActor.h"

namespace boxprobe::bench {

namespace {

vtkSmartPointer<vtkTexture> skyCube(const StockSky& sky) {
  constexpr int size = 256;
  auto cube = vtkSmartPointer<vtkTexture>::New();
  cube->CubeMapOn();
  cube->InterpolateOn();
  cube->MipmapOn();
  cube->SetColorModeToDirectScalars();
  for (int face = 0; face < 6; ++face) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(size, size, 1);
    image->AllocateScalars(VTK_FLOAT, 3);
    auto* texel = static_cast<float*>(image->GetScalarPointer());
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x, texel += 3) {
        const glm::vec3 direction =
            shading::cubeDirection(face, (2.0f * x + 1.0f) / size - 1.0f, (2.0f * y + 1.0f) / size - 1.0f);
        const glm::vec3 color = sky(glm::normalize(direction));
        for (int channel = 0; channel < 3; ++channel) texel[channel] = color[channel];
      }
    }
    cube->SetInputDataObject(face, image);
  }
  return cube;
}

}  // namespace

StockSky gradientSky(const SkyGradient& sky) {
  return
      [sky](const glm::vec3& direction) { return shading::skyGradient(direction, sky.top, sky.horizon, sky.ground); };
}

vtkSmartPointer<vtkActor> stockActor(vtkActor* ours) {
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(ours->GetMapper()->GetInputDataObject(0, 0));
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->DeepCopy(ours->GetProperty());
  actor->GetProperty()->SetEmissiveFactor(ours->GetProperty()->GetEmissiveFactor());  // VTK 9.1's copy leaves it out
  auto* lit = vtkProbeActor::SafeDownCast(ours);
  if (lit != nullptr && lit->GetPass()->GetSurface() != nullptr) {
    applyPlainSurface(*lit->GetPass()->GetSurface(), actor->GetProperty(), data);
  }
  mapper->SetInputData(data);
  actor->SetUserMatrix(ours->GetUserMatrix());
  actor->SetVisibility(ours->GetVisibility());
  return actor;
}

vtkSmartPointer<vtkOpenGLRenderer> makeStockRenderer(vtkRenderer* ours, const StockSky& sky, int irradianceSize) {
  auto stock = vtkSmartPointer<vtkOpenGLRenderer>::New();
  stock->SetActiveCamera(ours->GetActiveCamera());
  stock->SetUseDepthPeeling(ours->GetUseDepthPeeling());
  stock->SetUseFXAA(ours->GetUseFXAA());
  stock->SetTwoSidedLighting(ours->GetTwoSidedLighting());
  stock->AutomaticLightCreationOff();
  vtkLightCollection* lights = ours->GetLights();
  lights->InitTraversal();
  while (vtkLight* light = lights->GetNextItem()) stock->AddLight(light);
  vtkActorCollection* actors = ours->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor()) stock->AddActor(stockActor(actor));

  const vtkSmartPointer<vtkTexture> cube = skyCube(sky);
  stock->UseImageBasedLightingOn();
  stock->UseSphericalHarmonicsOff();  // they want a latitude-longitude picture
  stock->SetEnvironmentTexture(cube);
  // At VTK's default size the irradiance map alone takes 20 s of software rendering.
  stock->GetEnvMapIrradiance()->SetIrradianceSize(static_cast<unsigned int>(irradianceSize));
  vtkNew<vtkSkybox> skybox;
  skybox->SetTexture(cube);
  skybox->SetProjectionToCube();
  skybox->GammaCorrectOn();
  stock->AddActor(skybox);
  return stock;
}

}  // namespace boxprobe::bench
