#include "filters/vtk/widgets/wire_actors.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/geometry/probe_frame.h"
#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

namespace {

constexpr double kHiddenOpacity = 0.4;  ///< of lines hidden by the scene
constexpr double kHaloOpacity = 0.7;
constexpr double kHaloPixels = 2.0;      ///< added to a line's width
constexpr double kHaloBehind = 1.004;    ///< relative distance, so that the line is in front of its halo
constexpr double kDashesPerEdge = 32.0;  ///< for the longest edge
constexpr double kDashShare = 0.55;      ///< of a dash and its gap

vtkSmartPointer<vtkActor> lineActor(vtkRenderer* renderer, vtkPolyData* lines, const glm::dvec3& color, double width,
                                    double opacity) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->PickableOff();
  vtkProperty* property = actor->GetProperty();
  property->SetColor(color.x, color.y, color.z);
  property->SetLineWidth(static_cast<float>(width));
  property->SetOpacity(opacity);
  property->LightingOff();
  renderer->AddActor(actor);
  return actor;
}

void addEdges(std::vector<glm::dvec3>& segments, const Probe& probe, const Box& box, bool dashed) {
  const auto corners = boxCornersWorld(box, rotationMatrix(probe.rotationDegrees), probe.box.center());
  const glm::dvec3 size = box.size();
  const double period = std::max({size.x, size.y, size.z, 1e-6}) / kDashesPerEdge;
  for (const auto& edge : boxEdges()) {
    const glm::dvec3 from = corners[static_cast<std::size_t>(edge[0])];
    const glm::dvec3 to = corners[static_cast<std::size_t>(edge[1])];
    const double length = glm::length(to - from);
    if (!dashed) {
      segments.push_back(from);
      segments.push_back(to);
      continue;
    }
    if (length <= 0.0) continue;
    const glm::dvec3 direction = (to - from) / length;
    const int dashes = static_cast<int>(std::ceil(length / period));
    for (int i = 0; i < dashes; ++i) {
      const double start = i * period;
      segments.push_back(from + direction * start);
      segments.push_back(from + direction * std::min(start + period * kDashShare, length));
    }
  }
}

}  // namespace

HaloLines::HaloLines(vtkRenderer* renderer, const LineLook& look)
    : look_(look), lines_(vtkSmartPointer<vtkPolyData>::New()) {
  if (look.halo) {
    halo_ =
        lineActor(renderer, lines_, HandleColors().halo, look.widthPixels + kHaloPixels, kHaloOpacity * look.opacity);
  }
  core_ = lineActor(renderer, lines_, look.color, look.widthPixels, look.opacity);
  setVisible(true);
}

void HaloLines::setSegments(const std::vector<glm::dvec3>& endpointPairsWorld) {
  empty_ = endpointPairsWorld.empty();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  if (!empty_) anchorWorld_ = endpointPairsWorld.front();
  for (std::size_t i = 0; i + 1 < endpointPairsWorld.size(); i += 2) {
    vtkIdType ends[2];
    for (std::size_t end = 0; end < 2; ++end) {
      const glm::dvec3 p = endpointPairsWorld[i + end] - anchorWorld_;
      ends[end] = points->InsertNextPoint(p.x, p.y, p.z);
    }
    cells->InsertNextCell(2, ends);
  }
  lines_->SetPoints(points);
  lines_->SetLines(cells);
  lines_->Modified();
  setVisible(visible_);
  placeActors();
}

void HaloLines::setVisible(bool visible) {
  visible_ = visible;
  for (vtkActor* actor : {halo_.Get(), core_.Get()}) {
    if (actor) actor->SetVisibility(visible && !empty_ ? 1 : 0);
  }
}

void HaloLines::setColors(const glm::dvec3& line, const glm::dvec3& halo) {
  core_->GetProperty()->SetColor(line.x, line.y, line.z);
  if (halo_) halo_->GetProperty()->SetColor(halo.x, halo.y, halo.z);
}

void HaloLines::setPixelScale(double scale) {
  core_->GetProperty()->SetLineWidth(static_cast<float>(scale * look_.widthPixels));
  if (halo_) halo_->GetProperty()->SetLineWidth(static_cast<float>(scale * (look_.widthPixels + kHaloPixels)));
}

void HaloLines::pullTowards(const glm::dvec3& eyeWorld, double factor) {
  eyeWorld_ = eyeWorld;
  pull_ = factor;
  placeActors();
}

void HaloLines::placeActors() {
  const auto place = [this](vtkActor* actor, double factor) {
    // p -> eye + factor (anchor + p - eye)
    const glm::dvec3 shift = eyeWorld_ + factor * (anchorWorld_ - eyeWorld_);
    vtkNew<vtkMatrix4x4> matrix;
    for (int axis = 0; axis < 3; ++axis) {
      matrix->SetElement(axis, axis, factor);
      matrix->SetElement(axis, 3, shift[axis]);
    }
    actor->SetUserMatrix(matrix);
  };
  place(core_, pull_);
  if (halo_) place(halo_, pull_ * kHaloBehind);
}

WireActors::WireActors(vtkRenderer* renderer, bool faint)
    : idle_(renderer, {{}, 1.5, faint ? 0.3 : 0.8, !faint}),
      beside_(renderer, {{}, 1.5, faint ? kHiddenOpacity : 1.0, !faint}),
      influence_(renderer, {{}, 1.5, faint ? kHiddenOpacity : 1.0, !faint}),
      blend_(renderer, {{}, 1.5, faint ? kHiddenOpacity : 1.0, !faint}),
      box_(renderer, {{}, 2.5, faint ? kHiddenOpacity : 1.0, !faint}),
      ghost_(renderer, {{}, 2.5, faint ? kHiddenOpacity : 1.0, !faint}),
      drop_(renderer, {{}, 1.5, faint ? kHiddenOpacity : 1.0, !faint}) {
  setColors(HandleColors());
}

void WireActors::update(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                        const std::vector<std::size_t>& together, HandleMode mode) {
  std::vector<glm::dvec3> idle, beside, influence, blend, box;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const Probe& probe = probes[i];
    if (selected != i) {
      const bool also = std::binary_search(together.begin(), together.end(), i);
      addEdges(also ? beside : idle, probe, probe.box, false);
      continue;
    }
    addEdges(box, probe, probe.box, false);
    const bool own = probe.influence && !(*probe.influence == probe.box);
    if (own || mode == HandleMode::Influence) addEdges(influence, probe, probe.influenceBox(), false);
    const BlendDistance none{glm::dvec3(0.0), glm::dvec3(0.0)};
    if (!(probe.blendDistance == none)) addEdges(blend, probe, fullWeightBox(probe), true);
  }
  idle_.setSegments(idle);
  beside_.setSegments(beside);
  influence_.setSegments(influence);
  blend_.setSegments(blend);
  box_.setSegments(box);
}

void WireActors::setGhosts(const std::vector<Probe>& ghosts) {
  std::vector<glm::dvec3> edges;
  for (const Probe& ghost : ghosts) addEdges(edges, ghost, ghost.box, true);
  ghost_.setSegments(edges);
}

void WireActors::setDrop(const std::optional<std::array<glm::dvec3, 2>>& endsWorld) {
  std::vector<glm::dvec3> lines;
  if (endsWorld) {
    const glm::dvec3 foot = (*endsWorld)[1];
    constexpr double kCrossShare = 0.08;
    const double arm = kCrossShare * glm::length((*endsWorld)[0] - foot);
    lines.assign(endsWorld->begin(), endsWorld->end());
    for (const glm::dvec3& along : {glm::dvec3(arm, 0.0, 0.0), glm::dvec3(0.0, 0.0, arm)}) {
      lines.push_back(foot - along);
      lines.push_back(foot + along);
    }
  }
  drop_.setSegments(lines);
}

void WireActors::setColors(const HandleColors& colors) {
  idle_.setColors(colors.idle, colors.halo);
  beside_.setColors(colors.box, colors.halo);
  influence_.setColors(colors.influence, colors.halo);
  blend_.setColors(colors.blend, colors.halo);
  box_.setColors(colors.box, colors.halo);
  ghost_.setColors(colors.ghost, colors.halo);
  drop_.setColors(colors.origin, colors.halo);
}

void WireActors::setPixelScale(double scale) {
  for (HaloLines* lines : all()) lines->setPixelScale(scale);
}

void WireActors::pullTowards(const glm::dvec3& eyeWorld, double factor) {
  for (HaloLines* lines : all()) lines->pullTowards(eyeWorld, factor);
}

}  // namespace boxprobe
