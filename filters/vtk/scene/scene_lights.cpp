#include "filters/vtk/scene/scene_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>

namespace boxprobe {

namespace {

// Of each light its index among VTK's, or -1.
std::vector<int> placesOf(const std::vector<Light>& lights) {
  std::vector<int> places(lights.size());
  std::iota(places.begin(), places.end(), 0);
  if (lights.size() <= kMostOwnLights + 1) return places;
  const auto rank = [&lights](int i) {
    const Light& light = lights[static_cast<std::size_t>(i)];
    return light.type == LightType::Directional ? 0 : light.shadows != LightShadows::None ? 1 : 2;
  };
  std::vector<int> order = places;
  std::stable_sort(order.begin(), order.end(), [&rank](int a, int b) { return rank(a) < rank(b); });
  std::fill(places.begin(), places.end(), -1);
  for (std::size_t i = 0; i < kMostOwnLights; ++i) places[static_cast<std::size_t>(order[i])] = 0;
  int next = 0;
  for (int& place : places) place = place == 0 ? next++ : -1;
  return places;
}

}  // namespace

VtkLights makeLights(const Scene& scene, const glm::dvec3& center) {
  VtkLights made;
  made.places = placesOf(scene.lights);
  auto& lights = made.lights;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    if (made.places[i] < 0) continue;
    const Light& light = scene.lights[i];
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
  if (lights.size() < scene.lights.size()) {
    auto lending = vtkSmartPointer<vtkLight>::New();
    lending->SetLightTypeToSceneLight();
    lending->PositionalOn();
    lending->SetColor(0.0, 0.0, 0.0);
    lights.push_back(lending);
  }
  if (lights.empty()) {
    auto black = vtkSmartPointer<vtkLight>::New();
    black->SetLightTypeToHeadlight();
    black->SetColor(0.0, 0.0, 0.0);
    lights.push_back(black);
  }
  return made;
}

}  // namespace boxprobe
