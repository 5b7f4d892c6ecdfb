#include "filters/vtk/scene_lights.h"

#include <glm/geometric.hpp>

namespace boxprobe {

std::vector<vtkSmartPointer<vtkLight>> makeLights(const Scene& scene, const glm::dvec3& center) {
  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (const Light& light : scene.lights) {
    auto vtk = vtkSmartPointer<vtkLight>::New();
    vtk->SetLightTypeToSceneLight();
    vtk->SetColor(light.color.x, light.color.y, light.color.z);
    vtk->SetIntensity(light.intensity);
    if (light.type == LightType::Point) {
      vtk->PositionalOn();
      vtk->SetConeAngle(180.0);
      vtk->SetAttenuationValues(0.0, 0.0, 1.0);
      vtk->SetPosition(light.position.x, light.position.y, light.position.z);
      vtk->SetFocalPoint(light.position.x, light.position.y - 1.0, light.position.z);
    } else {
      // Beside a positional light VTK 9.1 shades a directional one from its position: from far away the two agree.
      constexpr double kFar = 1.0e6;
      const glm::dvec3 from = center - kFar * glm::normalize(light.direction);
      vtk->PositionalOff();
      vtk->SetPosition(from.x, from.y, from.z);
      vtk->SetFocalPoint(center.x, center.y, center.z);
    }
    lights.push_back(vtk);
  }
  if (lights.empty()) {
    auto black = vtkSmartPointer<vtkLight>::New();
    black->SetLightTypeToHeadlight();
    black->SetColor(0.0, 0.0, 0.0);
    lights.push_back(black);
  }
  return lights;
}

}  // namespace boxprobe
