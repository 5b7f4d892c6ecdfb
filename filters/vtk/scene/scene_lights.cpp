#include "filters/vtk/scene/scene_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace boxprobe {

std::vector<vtkSmartPointer<vtkLight>> makeLights(const Scene& scene, const glm::dvec3& center) {
  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (const Light& light : scene.lights) {
    auto vtk = vtkSmartPointer<vtkLight>::New();
    vtk->SetLightTypeToSceneLight();
    vtk->SetColor(light.color.x, light.color.y, light.color.z);
    vtk->SetIntensity(light.intensity);
    if (light.type != LightType::Directional) {
      // What the splice hands to shaders/shared/light_falloff.glsl: 1 / range and the cosine of the inner cone, in
      // the places of what VTK would make of an attenuation and an exponent.
      constexpr double kLargest = 1.0e30;  // single precision there
      const double perRange = light.range > 0.0 ? std::min(1.0 / light.range, kLargest) : 0.0;
      const bool spot = light.type == LightType::Spot;
      const glm::dvec3 to = light.position + (spot ? glm::normalize(light.direction) : glm::dvec3(0.0, -1.0, 0.0));
      vtk->PositionalOn();
      // From 90 degrees on VTK treats a light as omnidirectional.
      vtk->SetConeAngle(spot ? std::min(light.outerConeDegrees, 89.999) : 180.0);
      vtk->SetExponent(spot ? std::cos(glm::radians(light.innerConeDegrees)) : 1.0);
      vtk->SetAttenuationValues(perRange, 0.0, 1.0);
      vtk->SetPosition(light.position.x, light.position.y, light.position.z);
      vtk->SetFocalPoint(to.x, to.y, to.z);
    } else {
      // For pictures of plain VTK: before 9.5, if there is also a positional light, it shades a directional light from
      // its position; far away the two agree. The splice uses the direction.
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
