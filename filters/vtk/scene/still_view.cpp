#include "filters/vtk/scene/still_view.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkProp.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace boxprobe {

StillView::Key StillView::keyOf(vtkRenderer* renderer, const std::vector<vtkProp*>& props) {
  Key key;
  // The projection includes the angle, the near and far distances and shifts of the picture.
  vtkMatrix4x4* matrix =
      renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0);
  key.view.assign(matrix->GetData(), matrix->GetData() + 16);
  const int *size = renderer->GetSize(), *origin = renderer->GetOrigin();
  for (const int value : {size[0], size[1], origin[0], origin[1]}) key.view.push_back(value);
  key.view.push_back(renderer->GetRenderWindow()->GetMultiSamples());
  key.props.reserve(props.size());
  for (vtkProp* prop : props) key.props.emplace_back(prop, prop->GetRedrawMTime());
  return key;
}

bool StillView::begin(vtkRenderer* renderer, const std::vector<vtkProp*>& props) {
  Key now = keyOf(renderer, props);
  if (stage_ == Stage::Unknown || !(now == key_)) {
    key_ = std::move(now);
    stage_ = Stage::Drawn;
    return false;
  }
  const bool first = stage_ == Stage::Drawn;
  if (first) stage_ = Stage::Asked;  // and stays so if the frame fails
  return first;
}

void StillView::set(std::unordered_set<vtkProp*> hidden) {
  if (stage_ != Stage::Asked) return;
  hidden_ = std::move(hidden);
  stage_ = Stage::Known;
}

}  // namespace boxprobe
