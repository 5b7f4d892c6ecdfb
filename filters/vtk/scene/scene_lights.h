// A scene's lights as VTK lights.
#pragma once

#include <vtkLight.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "filters/core/geometry/light_shadow.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// VTK writes code for each light, and drivers compile it for longer than the number of lights grows. So it gets at
/// most one more than this: in scenes with more lights a loop reads the others from a list (draw/listed_lights.h), and
/// the last of VTK's lights, a black one, lends it its code.
constexpr std::size_t kMostOwnLights = kMostShadowLights;

struct VtkLights {
  /// Never empty: VTK writes no physically based code for a renderer without lights, so a scene without lights gets a
  /// black one.
  std::vector<vtkSmartPointer<vtkLight>> lights;
  /// For each of the scene's lights its index in `lights`; -1: in the list.
  std::vector<int> places;
};

/// `center`: the middle of the scene. Of many lights, VTK gets directional ones first, which may have shadow maps, then
/// those that ask for shadows.
VtkLights makeLights(const Scene& scene, const glm::dvec3& center);

}  // namespace boxprobe
