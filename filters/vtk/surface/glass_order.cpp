#include "filters/vtk/surface/glass_order.h"

#include <vtkCamera.h>
#include <vtkProp.h>

#include <algorithm>

#include "filters/vtk/surface/vtkProbeActor.h"

namespace boxprobe {

bool isGlass(vtkProp* prop) {
  auto* actor = vtkProbeActor::SafeDownCast(prop);
  return actor != nullptr && actor->GetPass()->DrawsGlass();
}

std::vector<vtkProp*> glassLast(const std::vector<vtkProp*>& props, vtkCamera* camera) {
  std::vector<vtkProp*> order;
  std::vector<std::pair<double, vtkProp*>> glass;
  const double* eye = camera->GetPosition();
  const double* along = camera->GetDirectionOfProjection();
  for (vtkProp* prop : props) {
    const double* b = isGlass(prop) ? prop->GetBounds() : nullptr;
    if (b == nullptr) {
      order.push_back(prop);
      continue;
    }
    double distance = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      distance += along[axis] * (0.5 * (b[2 * axis] + b[2 * axis + 1]) - eye[axis]);
    }
    glass.emplace_back(distance, prop);
  }
  std::stable_sort(glass.begin(), glass.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [distance, prop] : glass) order.push_back(prop);
  return order;
}

}  // namespace boxprobe
