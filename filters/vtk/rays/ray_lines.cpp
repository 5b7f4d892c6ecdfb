// See ray_lines.h.
#include "filters/vtk/rays/ray_lines.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

namespace boxprobe {

RayLines::RayLines() {
  points_->SetNumberOfComponents(3);
  hitPoint_->SetNumberOfComponents(3);
  direction_->SetNumberOfComponents(3);
  kind_->SetName(ray_array::kKind);
  status_->SetName(ray_array::kStatus);
  point_->SetName(ray_array::kPoint);
  probe_->SetName(ray_array::kProbe);
  face_->SetName(ray_array::kFace);
  hitPoint_->SetName(ray_array::kHitPoint);
  hitDistance_->SetName(ray_array::kHitDistance);
  direction_->SetName(ray_array::kDirection);
  level_->SetName(ray_array::kLevel);
  weight_->SetName(ray_array::kWeight);
  lookupShare_->SetName(ray_array::kLookupShare);
  trueDistance_->SetName(ray_array::kTrueDistance);
  error_->SetName(ray_array::kError);
  through_->SetName(ray_array::kThrough);
}

void RayLines::add(const RayLine& line) {
  points_->InsertNextTuple(&line.from.x);
  points_->InsertNextTuple(&line.to.x);
  kind_->InsertNextValue(static_cast<int>(line.kind));
  status_->InsertNextValue(line.status);
  point_->InsertNextValue(line.point);
  probe_->InsertNextValue(line.probe);
  face_->InsertNextValue(line.face);
  hitPoint_->InsertNextTuple(&line.hitPoint.x);
  hitDistance_->InsertNextValue(line.hitDistance);
  direction_->InsertNextTuple(&line.direction.x);
  level_->InsertNextValue(line.level);
  weight_->InsertNextValue(line.weight);
  lookupShare_->InsertNextValue(line.lookupShare);
  trueDistance_->InsertNextValue(line.trueDistance);
  error_->InsertNextValue(line.error);
  through_->InsertNextValue(line.through);
}

void RayLines::writeTo(vtkPolyData* output, const std::vector<std::string>& probeNames) const {
  vtkNew<vtkPoints> points;
  points->SetData(points_);
  vtkNew<vtkCellArray> lines;
  for (vtkIdType i = 0; i < kind_->GetNumberOfTuples(); ++i) {
    lines->InsertNextCell({2 * i, 2 * i + 1});
  }
  output->SetPoints(points);
  output->SetLines(lines);
  for (vtkDataArray* array :
       std::initializer_list<vtkDataArray*>{kind_, status_, point_, probe_, face_, hitPoint_, hitDistance_, direction_,
                                            level_, weight_, lookupShare_, trueDistance_, error_, through_}) {
    output->GetCellData()->AddArray(array);
  }
  vtkNew<vtkStringArray> probes, kinds;
  probes->SetName(ray_array::kProbeNames);
  for (const std::string& name : probeNames) probes->InsertNextValue(name);
  kinds->SetName(ray_array::kKindNames);
  for (const std::string_view name : kRayKindNames) kinds->InsertNextValue(std::string(name));
  output->GetFieldData()->AddArray(probes);
  output->GetFieldData()->AddArray(kinds);
}

}  // namespace boxprobe
