// See handle_actors.h.
#include "app/gui/handles/handle_actors.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <QColor>

#include "app/gui/widgets/axis_colors.h"

namespace boxprobe {

namespace {

constexpr double kFaceRadius = 7.0;  ///< logical pixels
constexpr double kOriginRadius = 9.0;
constexpr double kIdleOriginRadius = 6.0;
constexpr double kHighlightScale = 1.35;
constexpr double kOutlinePixels = 2.0;

vtkSmartPointer<vtkPolyData> sphere(int around, int across) {
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.0);
  source->SetThetaResolution(around);
  source->SetPhiResolution(across);
  source->Update();
  return source->GetOutput();
}

/// An octahedron with a normal a face, so that it reads as a cut stone and not as another ball.
vtkSmartPointer<vtkPolyData> octahedron() {
  const auto smooth = sphere(4, 3);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(smooth);
  normals->SetFeatureAngle(10.0);
  normals->SplittingOn();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkActor> addActor(vtkRenderer* renderer, vtkPolyData* shape) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->PickableOff();
  renderer->AddActor(actor);
  return actor;
}

void placeAt(vtkActor* actor, const glm::dvec3& positionWorld, double radius) {
  vtkNew<vtkMatrix4x4> matrix;
  for (int axis = 0; axis < 3; ++axis) {
    matrix->SetElement(axis, axis, radius);
    matrix->SetElement(axis, 3, positionWorld[axis]);
  }
  actor->SetUserMatrix(matrix);
}

}  // namespace

HandleActors::HandleActors(vtkRenderer* renderer) : renderer_(renderer), ball_(sphere(24, 16)), diamond_(octahedron()) {
  for (std::size_t i = 0; i < kBoxFaces.size(); ++i) faces_.push_back(newMark(ball_));
}

HandleActors::Mark HandleActors::newMark(vtkPolyData* shape) {
  Mark mark;
  // The outline is the same shape a little larger and dark, seen only where its far side looks out behind the body.
  mark.outline = addActor(renderer_, shape);
  mark.outline->GetProperty()->LightingOff();
  mark.outline->GetProperty()->FrontfaceCullingOn();
  const QColor halo = haloColor();
  mark.outline->GetProperty()->SetColor(halo.redF(), halo.greenF(), halo.blueF());
  mark.body = addActor(renderer_, shape);
  mark.body->GetProperty()->SetAmbient(0.45);
  mark.body->GetProperty()->SetDiffuse(0.6);
  return mark;
}

void HandleActors::place(Mark& mark, const std::vector<Probe>& probes, const Handle& handle, bool selected,
                         bool highlighted) {
  mark.positionWorld = handlePositionWorld(probes, handle);
  const bool face = handle.kind == HandleKind::Face;
  QColor color = face ? axisColor(handle.face.axis) : selected ? originColor() : idleColor();
  mark.radiusPixels = face ? kFaceRadius : selected ? kOriginRadius : kIdleOriginRadius;
  if (highlighted) {
    mark.radiusPixels *= kHighlightScale;
    color = color.lighter(140);
  }
  mark.body->GetProperty()->SetColor(color.redF(), color.greenF(), color.blueF());
}

void HandleActors::update(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                          std::optional<Handle> highlighted) {
  while (origins_.size() < probes.size()) origins_.push_back(newMark(diamond_));
  shownOrigins_ = probes.size();
  shownFaces_ = selected.has_value();
  for (const Handle& handle : handles(probes, selected)) {
    Mark& mark = handle.kind == HandleKind::Face ? faces_[static_cast<std::size_t>(handle.face.index())]
                                                 : origins_[handle.probe];
    place(mark, probes, handle, selected == handle.probe, highlighted && *highlighted == handle);
  }
  setVisible(visible_);
}

void HandleActors::setVisible(bool visible) {
  visible_ = visible;
  const auto show = [](const Mark& mark, bool shown) {
    mark.body->SetVisibility(shown ? 1 : 0);
    mark.outline->SetVisibility(shown ? 1 : 0);
  };
  for (const Mark& mark : faces_) show(mark, visible && shownFaces_);
  for (std::size_t i = 0; i < origins_.size(); ++i) show(origins_[i], visible && i < shownOrigins_);
}

void HandleActors::fit(const ViewProjection& view) {
  const auto fitMark = [&](const Mark& mark) {
    const double metres = view.metresPerPixel(mark.positionWorld);
    placeAt(mark.body, mark.positionWorld, metres * mark.radiusPixels);
    placeAt(mark.outline, mark.positionWorld, metres * (mark.radiusPixels + kOutlinePixels));
  };
  for (const Mark& mark : faces_) fitMark(mark);
  for (const Mark& mark : origins_) fitMark(mark);
}

}  // namespace boxprobe
