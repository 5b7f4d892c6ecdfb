// A scene's lights as VTK lights.
#pragma once

#include <vtkLight.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Never empty: VTK writes no physically based code for a renderer without lights, so a scene without lights gets a
/// black one. `center`: the middle of the scene.
std::vector<vtkSmartPointer<vtkLight>> makeLights(const Scene& scene, const glm::dvec3& center);

}  // namespace boxprobe
