#include "filters/vtk/widgets/handle_actors.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

namespace {

constexpr double kFaceRadius = 7.0;  ///< logical pixels
constexpr double kBlendRadius = 5.5;
constexpr double kOriginRadius = 9.0;
constexpr double kIdleOriginRadius = 6.0;
constexpr double kHighlightScale = 1.35;
constexpr double kOutlinePixels = 2.0;
constexpr float kRingWidth = 3.5F;

vtkSmartPointer<vtkPolyData> sphere(int around, int across) {
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.0);
  source->SetThetaResolution(around);
  source->SetPhiResolution(across);
  source->Update();
  return source->GetOutput();
}

/// An octahedron with face normals, so that it looks different from a ball.
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

/// A cube whose corners are about as far out as the ball's surface.
vtkSmartPointer<vtkPolyData> cube() {
  vtkNew<vtkCubeSource> source;
  for (const auto set : {&vtkCubeSource::SetXLength, &vtkCubeSource::SetYLength, &vtkCubeSource::SetZLength}) {
    (source.Get()->*set)(1.6);
  }
  source->Update();
  return source->GetOutput();
}

/// Along X, of length 1.
vtkSmartPointer<vtkPolyData> arrow() {
  vtkNew<vtkArrowSource> source;
  source->SetTipLength(0.22);
  source->SetTipRadius(0.07);
  source->SetTipResolution(20);
  source->SetShaftRadius(0.022);
  source->SetShaftResolution(12);
  source->Update();
  return source->GetOutput();
}

/// About X, of radius 1.
vtkSmartPointer<vtkPolyData> ring() {
  constexpr int kSides = 96;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(kSides + 1);
  for (int i = 0; i < kSides; ++i) {
    const double angle = glm::radians(360.0 * i / kSides);
    points->InsertNextPoint(0.0, std::cos(angle), std::sin(angle));
    cells->InsertCellPoint(i);
  }
  cells->InsertCellPoint(0);
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  lines->SetPoints(points);
  lines->SetLines(cells);
  return lines;
}

void setMatrix(vtkActor* actor, const glm::dmat3& axes, const glm::dvec3& positionWorld) {
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, axes[column][row]);
    matrix->SetElement(row, 3, positionWorld[row]);
  }
  actor->SetUserMatrix(matrix);
}

/// A frame whose third axis is along the ray through the point instead of the view direction, so that shapes look round
/// at the picture's edge as well.
glm::dmat3 screenFrame(const ViewProjection& view, const glm::dvec3& positionWorld) {
  const ViewAxes axes = view.axes();
  glm::dvec3 away = positionWorld - view.eyeWorld();
  const double depth = glm::dot(away, axes.forward);
  away = view.parallel() || depth <= 0.0 ? axes.forward : away / depth;
  return {view.right(), axes.up, -away};
}

void setColor(vtkActor* actor, const glm::dvec3& color) {
  actor->GetProperty()->SetColor(color.x, color.y, color.z);
}

/// 1.4 times as bright, desaturated where that exceeds white.
glm::dvec3 highlightedColor(const glm::dvec3& color) {
  constexpr double kBrighter = 1.4;
  double h, s, v, r, g, b;
  vtkMath::RGBToHSV(color.x, color.y, color.z, &h, &s, &v);
  v *= kBrighter;
  s = std::max(s - std::max(v - 1.0, 0.0), 0.0);
  vtkMath::HSVToRGB(h, s, std::min(v, 1.0), &r, &g, &b);
  return {r, g, b};
}

}  // namespace

HandleActors::HandleActors(vtkRenderer* renderer) : renderer_(renderer), diamond_(octahedron()) {
  const auto ball = sphere(24, 16), small = cube(), pointing = arrow(), circle = ring();
  for (std::size_t i = 0; i < kBoxFaces.size(); ++i) {
    faces_.push_back(newMark(ball, Form::Round));
    blends_.push_back(newMark(small, Form::Round));
  }
  for (int axis = 0; axis < 3; ++axis) {
    rings_.push_back(newMark(circle, Form::Ring));
    arrows_.push_back(newMark(pointing, Form::Pointing));
  }
}

HandleActors::Mark HandleActors::newMark(vtkPolyData* shape, Form form) {
  Mark mark;
  mark.form = form;
  // The outline is a slightly larger copy with front-face culling, visible around the body.
  mark.outline = addActor(renderer_, shape);
  mark.outline->GetProperty()->LightingOff();
  mark.body = addActor(renderer_, shape);
  if (form == Form::Ring) {
    mark.body->GetProperty()->SetLineWidth(kRingWidth);
    mark.body->GetProperty()->LightingOff();
  } else {
    mark.outline->GetProperty()->FrontfaceCullingOn();
    mark.body->GetProperty()->SetAmbient(0.45);
    mark.body->GetProperty()->SetDiffuse(0.6);
  }
  return mark;
}

HandleActors::Mark& HandleActors::markOf(const Handle& handle) {
  const auto axis = static_cast<std::size_t>(handle.face.axis), face = static_cast<std::size_t>(handle.face.index());
  switch (handle.kind) {
    case HandleKind::Face:
    case HandleKind::Influence:
      return faces_[face];
    case HandleKind::Blend:
      return blends_[face];
    case HandleKind::Move:
    case HandleKind::OriginAxis:
      return arrows_[axis];
    case HandleKind::Turn:
      return rings_[axis];
    case HandleKind::Origin:
      break;
  }
  return origins_[handle.probe];
}

void HandleActors::place(Mark& mark, const std::vector<Probe>& probes, const Handle& handle, Rank rank,
                         bool highlighted) {
  const Probe& probe = probes[handle.probe];
  mark.shown = true;
  mark.idle = handle.kind == HandleKind::Origin && rank == Rank::Idle;
  mark.positionWorld = handleAnchorWorld(probe, handle);
  const bool origin = handle.kind == HandleKind::Origin;
  glm::dvec3 color = !origin              ? colors_.axes[static_cast<std::size_t>(handle.face.axis)]
                     : rank != Rank::Idle ? colors_.origin
                                          : colors_.idle;
  glm::dvec3 rim = colors_.halo;
  mark.outlinePixels = kOutlinePixels;
  mark.radiusPixels = origin                             ? (rank == Rank::Shown ? kOriginRadius : kIdleOriginRadius)
                      : handle.kind == HandleKind::Blend ? kBlendRadius
                      : mark.form == Form::Pointing      ? kArrowPixels
                      : mark.form == Form::Ring          ? kRingPixels
                                                         : kFaceRadius;
  mark.radiusPixels *= size_;
  if (highlighted) color = highlightedColor(color);
  if (highlighted && mark.form == Form::Round) mark.radiusPixels *= kHighlightScale;
  if (mark.form == Form::Round && !origin && !handle.face.positive) {
    rim = color;
    color = colors_.halo;
    mark.outlinePixels = 1.5 * kOutlinePixels;
  }
  if (mark.form != Form::Round) {
    const glm::dvec3 axis = handleAxisWorld(probe, handle);
    const glm::dvec3 other = std::abs(axis.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 side = glm::normalize(glm::cross(axis, other));
    mark.frame = glm::dmat3(axis, side, glm::cross(axis, side));
  }
  setColor(mark.body, color);
  setColor(mark.outline, rim);
}

void HandleActors::forAll(const std::function<void(Mark&)>& work) {
  for (std::vector<Mark>* marks : {&faces_, &blends_, &arrows_, &rings_, &origins_}) {
    for (Mark& mark : *marks) work(mark);
  }
}

void HandleActors::update(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                          const std::vector<std::size_t>& together, std::optional<Handle> highlighted,
                          HandleMode mode) {
  while (origins_.size() < probes.size()) origins_.push_back(newMark(diamond_, Form::Round));
  forAll([](Mark& mark) { mark.shown = false; });
  for (const Handle& handle : handles(probes, selected, mode)) {
    const bool beside = std::binary_search(together.begin(), together.end(), handle.probe);
    const Rank rank = selected == handle.probe ? Rank::Shown : beside ? Rank::Beside : Rank::Idle;
    place(markOf(handle), probes, handle, rank, highlighted && *highlighted == handle);
  }
  forAll([](Mark& mark) {
    mark.body->SetVisibility(mark.shown ? 1 : 0);
    mark.outline->SetVisibility(mark.shown && mark.form == Form::Round ? 1 : 0);
  });
}

void HandleActors::setLook(const HandleColors& colors, double size) {
  colors_ = colors;
  size_ = size;
}

void HandleActors::setPixelScale(double scale) {
  for (const Mark& ring : rings_) ring.body->GetProperty()->SetLineWidth(kRingWidth * static_cast<float>(scale));
}

double HandleActors::fadeOf(const Mark& mark, const ViewProjection& view, double nearest) {
  constexpr double kFull = 3.0;  ///< times the nearest distance, where fading starts
  constexpr double kLeast = 0.35;
  if (!mark.idle) return 1.0;
  const double distance = glm::length(mark.positionWorld - view.eyeWorld());
  return distance > 0.0 ? std::clamp(kFull * nearest / distance, kLeast, 1.0) : 1.0;
}

void HandleActors::fit(const ViewProjection& view) {
  double nearest = std::numeric_limits<double>::max();
  forAll([&](Mark& mark) {
    if (mark.shown && mark.idle) nearest = std::min(nearest, glm::length(mark.positionWorld - view.eyeWorld()));
  });
  forAll([&](Mark& mark) {
    if (!mark.shown) return;
    const double fade = fadeOf(mark, view, nearest);
    for (vtkActor* actor : {mark.body.Get(), mark.outline.Get()}) actor->GetProperty()->SetOpacity(fade);
    const double metres = fade * view.metresPerPixel(mark.positionWorld);
    const glm::dmat3 frame = mark.form == Form::Round ? screenFrame(view, mark.positionWorld) : mark.frame;
    setMatrix(mark.body, frame * (metres * mark.radiusPixels), mark.positionWorld);
    const double outline = mark.form == Form::Round ? mark.radiusPixels + mark.outlinePixels : mark.radiusPixels;
    setMatrix(mark.outline, frame * (metres * outline), mark.positionWorld);
  });
}

}  // namespace boxprobe
