#include "filters/vtk/scene/camera_values.h"

#include <vtkCamera.h>

namespace boxprobe {

void setCamera(vtkCamera* to, const Camera& camera) {
  to->SetPosition(camera.position.x, camera.position.y, camera.position.z);
  to->SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
  to->SetViewUp(camera.up.x, camera.up.y, camera.up.z);
  to->SetViewAngle(camera.verticalFovDegrees);
  to->SetParallelProjection(camera.parallelHeight > 0.0);
  if (camera.parallelHeight > 0.0) to->SetParallelScale(0.5 * camera.parallelHeight);
}

Camera cameraValues(vtkCamera* from) {
  Camera camera;
  from->GetPosition(&camera.position.x);
  from->GetFocalPoint(&camera.target.x);
  from->GetViewUp(&camera.up.x);
  camera.verticalFovDegrees = from->GetViewAngle();
  camera.parallelHeight = from->GetParallelProjection() != 0 ? 2.0 * from->GetParallelScale() : 0.0;
  return camera;
}

}  // namespace boxprobe
