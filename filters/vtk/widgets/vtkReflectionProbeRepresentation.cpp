#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/widgets/actor_surfaces.h"
#include "filters/vtk/widgets/handle_layers.h"
#include "filters/vtk/widgets/handle_picking.h"
#include "filters/vtk/widgets/handle_readout.h"

vtkStandardNewMacro(vtkReflectionProbeRepresentation);

namespace {

using namespace boxprobe;

constexpr double kUsualHandleSize = 14.0;  ///< the size at which the sizes in handle_actors.cpp apply
constexpr double kClickPixels = 2.0;       ///< a press with less movement is a click
constexpr double kFineShare = 0.1;         ///< fraction of the pointer's movement in fine mode
constexpr double kThinnestShare = 0.01;    ///< of the box, for small boxes
constexpr double kPointsPerInch = 72.0;

void put(const glm::dvec3& from, double* to) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

glm::dvec3 toVector(const double* v) {
  return {v[0], v[1], v[2]};
}

struct SixValues {
  SixValues(const glm::dvec3& low, const glm::dvec3& high) : values{low.x, high.x, low.y, high.y, low.z, high.z} {}
  double values[6];
};

int stateOf(const std::optional<Handle>& handle) {
  using Representation = vtkReflectionProbeRepresentation;
  if (!handle) return Representation::Outside;
  switch (handle->kind) {
    case HandleKind::Face:
      return Representation::MovingFace;
    case HandleKind::Influence:
      return Representation::MovingInfluence;
    case HandleKind::Blend:
      return Representation::MovingBlend;
    case HandleKind::OriginAxis:
      return Representation::MovingOriginAlongAxis;
    case HandleKind::Move:
      return Representation::Translating;
    case HandleKind::Turn:
      return Representation::Rotating;
    case HandleKind::Origin:
      break;
  }
  return Representation::MovingOrigin;
}

}  // namespace

struct vtkReflectionProbeRepresentation::Parts {
  vtkSmartPointer<vtkReflectionProbe> probe;
  vtkMTimeType probeTime = 0;

  std::vector<Probe> probes;  ///< that of `probe`, or those of ShowProbes()
  std::optional<std::size_t> selected;
  std::vector<std::size_t> together;
  std::vector<bool> hidden, locked;
  std::vector<Probe> ghosts;
  std::optional<std::array<glm::dvec3, 2>> drop;
  bool othersChanged = false;  ///< ghosts or drop line
  std::optional<Handle> hovered;

  /// All values of a probe that drags change.
  struct Placement {
    explicit Placement(vtkReflectionProbe* probe)
        : originAtCenter(probe->GetOriginAtCenter()), useInfluence(probe->GetUseInfluenceBounds()) {
      probe->GetBounds(bounds);
      probe->GetOrigin(origin);
      probe->GetOrientation(orientation);
      probe->GetInfluenceBounds(influence);
      probe->GetBlendDistances(blend);
    }
    void restore(vtkReflectionProbe* probe) const {
      probe->SetBounds(bounds);
      if (!originAtCenter) probe->SetOrigin(origin);
      probe->SetOriginAtCenter(originAtCenter);
      probe->SetOrientation(orientation);
      probe->SetInfluenceBounds(influence);
      probe->SetUseInfluenceBounds(useInfluence);
      probe->SetBlendDistances(blend);
    }

    double bounds[6], origin[3], orientation[3], influence[6], blend[6];
    bool originAtCenter, useInfluence;
  };

  struct Drag {
    ProbeDrag drag;
    Probe now;                        ///< the last result
    glm::dvec2 pressed, pixel, held;  ///< held: lags behind the pointer after fine mode
    bool moved = false;
    std::optional<Placement> before;  ///< of `probe`
  };
  std::optional<Drag> drag;
  std::string readout;

  std::function<const SurfaceRays*()> surfaces;
  std::unique_ptr<ActorSurfaces> actorSurfaces;  ///< for the current drag
  std::function<std::string(const char*)> words;
  std::unique_ptr<HandleLayers> layers;
  double bounds[6];

  static bool has(const std::vector<bool>& marks, std::size_t index) { return index < marks.size() && marks[index]; }
  /// Those left after hidden ones, and locked ones if `free`: the probes and their places among all.
  struct Left {
    std::vector<Probe> probes;
    std::vector<std::size_t> of;
    std::optional<std::size_t> at(std::optional<std::size_t> index) const {
      const auto found = index ? std::lower_bound(of.begin(), of.end(), *index) : of.end();
      return found != of.end() && *found == *index ? std::optional<std::size_t>(found - of.begin()) : std::nullopt;
    }
  };
  Left left(bool free) const {
    Left rest;
    for (std::size_t i = 0; i < probes.size(); ++i) {
      if (has(hidden, i) || (free && has(locked, i))) continue;
      rest.probes.push_back(probes[i]);
      rest.of.push_back(i);
    }
    return rest;
  }
  bool anyLeftOut() const {
    const auto any = [](const std::vector<bool>& marks) {
      return std::find(marks.begin(), marks.end(), true) != marks.end();
    };
    return any(hidden) || any(locked);
  }
  /// Shows what is left in the layers.
  void updateLayers(HandleMode mode) {
    if (!anyLeftOut()) return layers->update(probes, selected, together, hovered, mode);
    const Left rest = left(false);
    std::vector<std::size_t> beside;
    for (const std::size_t index : together) {
      if (const auto at = rest.at(index)) beside.push_back(*at);
    }
    std::optional<Handle> highlighted = hovered;
    if (highlighted) {
      const auto at = rest.at(highlighted->probe);
      at ? void(highlighted->probe = *at) : highlighted.reset();
    }
    layers->update(rest.probes, rest.at(selected), beside, highlighted, mode);
  }

  double pixelScale(vtkRenderer* renderer) const {
    vtkWindow* window = renderer != nullptr ? renderer->GetVTKWindow() : nullptr;
    return window != nullptr ? window->GetDPI() / kPointsPerInch : 1.0;
  }
  glm::dvec2 viewPixels(vtkRenderer* renderer) const {
    const int* size = renderer->GetSize();
    return glm::dvec2(size[0], size[1]) / pixelScale(renderer);
  }
  ViewProjection view(vtkRenderer* renderer) const {
    const glm::dvec2 size = viewPixels(renderer);
    return {renderer->GetActiveCamera(), size.x, size.y};
  }
  glm::dvec2 pixel(vtkRenderer* renderer, double x, double y) const {
    const int* origin = renderer->GetOrigin();
    const glm::dvec2 fromBelow = glm::dvec2(x - origin[0], y - origin[1]) / pixelScale(renderer);
    return {fromBelow.x, viewPixels(renderer).y - fromBelow.y};
  }
  /// Writes only what has changed: moving a box does not set an origin that is not its centre, which would cause a
  /// capture.
  void write(const Probe& now) const {
    vtkReflectionProbe* to = probe;
    to->SetBounds(SixValues(now.box.min, now.box.max).values);
    const HandleKind kind = drag->drag.handle().kind;
    const bool atCenter = drag->before->originAtCenter;
    if (!atCenter || kind == HandleKind::Origin || kind == HandleKind::OriginAxis) {
      to->SetOrigin(now.origin.x, now.origin.y, now.origin.z);
    }
    to->SetOrientation(now.rotationDegrees.x, now.rotationDegrees.y, now.rotationDegrees.z);
    to->SetBlendDistances(SixValues(now.blendDistance.min, now.blendDistance.max).values);
    if (!now.influence) return;
    to->SetInfluenceBounds(SixValues(now.influence->min, now.influence->max).values);
    to->SetUseInfluenceBounds(true);
  }
};

vtkReflectionProbeRepresentation::vtkReflectionProbeRepresentation() : Inside(std::make_unique<Parts>()) {
  this->HandleSize = kUsualHandleSize;
  this->InteractionState = Outside;
  const HandleColors colors;
  put(colors.axes[0], this->XAxisColor);
  put(colors.axes[1], this->YAxisColor);
  put(colors.axes[2], this->ZAxisColor);
  put(colors.box, this->BoxColor);
  put(colors.influence, this->InfluenceColor);
  put(colors.blend, this->BlendColor);
  put(colors.origin, this->OriginColor);
  put(colors.halo, this->HaloColor);
}

vtkReflectionProbeRepresentation::~vtkReflectionProbeRepresentation() = default;

vtkMTimeType vtkReflectionProbeRepresentation::GetMTime() {
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Inside->probe ? std::max(own, this->Inside->probe->GetMTime()) : own;
}

void vtkReflectionProbeRepresentation::SetProbe(vtkReflectionProbe* probe) {
  Parts& in = *this->Inside;
  if (probe == in.probe) return;
  this->LetGo();
  in.probe = probe;
  in.probeTime = 0;
  in.probes.clear();
  in.selected.reset();
  in.together.clear();
  this->SetHovered(Outside);
  this->Modified();
}

vtkReflectionProbe* vtkReflectionProbeRepresentation::GetProbe() const {
  return this->Inside->probe;
}

void vtkReflectionProbeRepresentation::SetMode(int mode) {
  const int clamped = std::clamp<int>(mode, BOX, PLACE);
  if (clamped == this->Mode) return;
  this->CancelInteraction();
  this->Mode = clamped;
  this->SetHovered(Outside);
  this->Modified();
}

const char* vtkReflectionProbeRepresentation::GetReadout() const {
  return this->Inside->readout.c_str();
}

int vtkReflectionProbeRepresentation::GetInteractionFace() const {
  const auto& handle = this->Inside->hovered;
  return handle && isFace(*handle) ? 2 * handle->face.axis + (handle->face.positive ? 1 : 0) : -1;
}

int vtkReflectionProbeRepresentation::GetInteractionAxis() const {
  const auto& handle = this->Inside->hovered;
  return handle && handle->kind != HandleKind::Origin ? handle->face.axis : -1;
}

bool vtkReflectionProbeRepresentation::GetDragging() const {
  return this->Inside->drag.has_value();
}

// With SetProbe() the probe's current values are shown.
void vtkReflectionProbeRepresentation::Refresh() {
  Parts& in = *this->Inside;
  if (!in.probe || in.probe->GetMTime() == in.probeTime) return;
  in.probeTime = in.probe->GetMTime();
  in.probes = {in.probe->ToProbe(std::string())};
  in.selected = 0;
  in.together = {0};
}

void vtkReflectionProbeRepresentation::SetHovered(int state) {
  if (state == Outside && this->Inside->hovered) {
    this->Inside->hovered.reset();
    this->Modified();
    this->NeedToRender = 1;
  }
  this->InteractionState = state;
}

void vtkReflectionProbeRepresentation::SetRenderer(vtkRenderer* renderer) {
  if (renderer != this->Renderer) {
    this->CancelInteraction();
    this->SetHovered(Outside);
    this->Inside->layers.reset();
  }
  this->Superclass::SetRenderer(renderer);
  this->MakeLayers();
}

// A renderer may be added to its window late, or to another one.
void vtkReflectionProbeRepresentation::MakeLayers() {
  Parts& in = *this->Inside;
  vtkRenderWindow* window = this->Renderer != nullptr ? this->Renderer->GetRenderWindow() : nullptr;
  if (in.layers && in.layers->window() == window && window != nullptr) return;
  in.layers.reset();
  if (window == nullptr) return;
  in.layers = std::make_unique<HandleLayers>(window, this->Renderer);
  in.layers->setDrawn(this->GetVisibility() != 0);
  in.othersChanged = true;
  this->Modified();
}

void vtkReflectionProbeRepresentation::BuildRepresentation() {
  if (this->Renderer == nullptr) return;
  this->Follow(this->Inside->view(this->Renderer));
}

int vtkReflectionProbeRepresentation::RenderOpaqueGeometry(vtkViewport* viewport) {
  if (viewport == this->Renderer) this->BuildRepresentation();
  return 0;
}

void vtkReflectionProbeRepresentation::PlaceWidget(double bounds[6]) {
  if (!this->Inside->probe) return;
  double placed[6], center[3];
  this->AdjustBounds(bounds, placed, center);
  this->Inside->probe->SetBounds(placed);
}

double* vtkReflectionProbeRepresentation::GetBounds() {
  Parts& in = *this->Inside;
  this->Refresh();
  if (!in.selected) return nullptr;
  const Probe& probe = in.probes[*in.selected];
  glm::dvec3 low = probe.origin, high = probe.origin;
  for (const Box& box : {probe.box, probe.influenceBox()}) {
    for (const glm::dvec3& corner : boxCornersWorld(box, rotationMatrix(probe.rotationDegrees), probe.box.center())) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  std::copy_n(SixValues(low, high).values, 6, in.bounds);
  return in.bounds;
}

void vtkReflectionProbeRepresentation::SetVisibility(vtkTypeBool visible) {
  this->Superclass::SetVisibility(visible);
  if (this->Inside->layers) this->Inside->layers->setDrawn(visible != 0);
}

void vtkReflectionProbeRepresentation::Highlight(int highlighted) {
  if (highlighted == 0 && !this->GetDragging()) this->SetHovered(Outside);
}

int vtkReflectionProbeRepresentation::ComputeInteractionState(int x, int y, int vtkNotUsed(modify)) {
  if (this->GetDragging()) return this->InteractionState;
  this->Refresh();
  if (this->Renderer == nullptr) {
    this->SetHovered(Outside);
  } else {
    this->Hover(this->Inside->view(this->Renderer), this->Inside->pixel(this->Renderer, x, y));
  }
  return this->InteractionState;
}

void vtkReflectionProbeRepresentation::StartWidgetInteraction(double eventPosition[2]) {
  if (this->Renderer == nullptr || this->GetDragging()) return;
  Parts& in = *this->Inside;
  this->Refresh();
  const ViewProjection view = in.view(this->Renderer);
  const glm::dvec2 pixel = in.pixel(this->Renderer, eventPosition[0], eventPosition[1]);
  this->Hover(view, pixel);
  this->Grab(view, pixel);
}

void vtkReflectionProbeRepresentation::WidgetInteraction(double eventPosition[2]) {
  Parts& in = *this->Inside;
  if (this->Renderer == nullptr || !in.drag) return;
  const glm::dvec2 pixel = in.pixel(this->Renderer, eventPosition[0], eventPosition[1]);
  const auto now = this->Pull(in.view(this->Renderer), pixel);
  if (now && in.probe) in.write(*now);
}

void vtkReflectionProbeRepresentation::EndWidgetInteraction(double vtkNotUsed(eventPosition)[2]) {
  this->LetGo();
}

void vtkReflectionProbeRepresentation::CancelInteraction() {
  Parts& in = *this->Inside;
  if (in.drag && in.drag->before && in.probe) in.drag->before->restore(in.probe);
  this->LetGo();
}

void vtkReflectionProbeRepresentation::ShowProbes(const std::vector<Probe>& probes, std::optional<std::size_t> selected,
                                                  const std::vector<std::size_t>& together) {
  Parts& in = *this->Inside;
  in.probe = nullptr;
  in.probes = probes;
  in.selected = selected && *selected < probes.size() ? selected : std::nullopt;
  in.together = together;
  if (in.hovered && in.hovered->probe >= probes.size()) this->SetHovered(Outside);
  this->Modified();
}

void vtkReflectionProbeRepresentation::LeaveOut(std::vector<bool> hidden, std::vector<bool> locked) {
  Parts& in = *this->Inside;
  if (hidden == in.hidden && locked == in.locked) return;
  in.hidden = std::move(hidden);
  in.locked = std::move(locked);
  if (in.hovered && !this->GetDragging()) this->SetHovered(Outside);
  this->Modified();
}

void vtkReflectionProbeRepresentation::ShowGhosts(const std::vector<Probe>& ghosts) {
  this->Inside->ghosts = ghosts;
  this->Inside->othersChanged = true;
}

void vtkReflectionProbeRepresentation::ShowDrop(const std::optional<std::array<glm::dvec3, 2>>& endsWorld) {
  if (endsWorld == this->Inside->drop) return;
  this->Inside->drop = endsWorld;
  this->Inside->othersChanged = true;
}

void vtkReflectionProbeRepresentation::SetSurfaces(std::function<const SurfaceRays*()> surfaces) {
  this->Inside->surfaces = std::move(surfaces);
}

void vtkReflectionProbeRepresentation::SetReadoutWords(std::function<std::string(const char*)> words) {
  this->Inside->words = std::move(words);
}

void vtkReflectionProbeRepresentation::Follow(const ViewProjection& view) {
  this->MakeLayers();
  Parts& in = *this->Inside;
  if (!in.layers) return;
  this->Refresh();
  if (this->GetMTime() > this->BuildTime.GetMTime()) {
    HandleColors colors;
    colors.axes = {toVector(this->XAxisColor), toVector(this->YAxisColor), toVector(this->ZAxisColor)};
    colors.box = toVector(this->BoxColor);
    colors.influence = toVector(this->InfluenceColor);
    colors.blend = toVector(this->BlendColor);
    colors.origin = toVector(this->OriginColor);
    colors.halo = toVector(this->HaloColor);
    in.layers->setLook(colors, this->HandleSize / kUsualHandleSize);
    in.updateLayers(static_cast<HandleMode>(this->Mode));
    this->BuildTime.Modified();
  }
  if (in.othersChanged) {
    in.layers->setGhosts(in.ghosts);
    in.layers->setDrop(in.drop);
    in.othersChanged = false;
  }
  in.layers->follow(view, in.pixelScale(this->Renderer));
  in.layers->setReadout(this->ReadoutVisibility ? in.readout : std::string(),
                        in.drag ? in.drag->pixel : glm::dvec2(0.0), in.viewPixels(this->Renderer));
}

std::optional<Handle> vtkReflectionProbeRepresentation::HandleAt(const ViewProjection& view,
                                                                 const glm::dvec2& pixel) const {
  const Parts& in = *this->Inside;
  if (this->Visibility == 0) return std::nullopt;
  const double reach = 0.5 * this->HandleSize + this->Tolerance, size = this->HandleSize / kUsualHandleSize;
  const auto mode = static_cast<HandleMode>(this->Mode);
  if (!in.anyLeftOut()) return handleAt(in.probes, in.selected, view, pixel, reach, mode, size);
  const Parts::Left free = in.left(true);
  auto handle = handleAt(free.probes, free.at(in.selected), view, pixel, reach, mode, size);
  if (handle) handle->probe = free.of[handle->probe];
  return handle;
}

std::optional<Handle> vtkReflectionProbeRepresentation::Hover(const ViewProjection& view, const glm::dvec2& pixel) {
  Parts& in = *this->Inside;
  const auto under = this->HandleAt(view, pixel);
  if (!(under == in.hovered)) {
    in.hovered = under;
    this->Modified();
    this->NeedToRender = 1;
  }
  this->InteractionState = stateOf(under);
  return under;
}

const std::optional<Handle>& vtkReflectionProbeRepresentation::GetHovered() const {
  return this->Inside->hovered;
}

bool vtkReflectionProbeRepresentation::Grab(const ViewProjection& view, const glm::dvec2& pixel) {
  Parts& in = *this->Inside;
  if (in.drag || !in.hovered || in.selected != in.hovered->probe) return false;
  const Probe& probe = in.probes[*in.selected];
  double thinnest = kMinimumThickness;
  if (in.probe) {
    const double size = probe.box.size()[in.hovered->face.axis];
    thinnest = std::clamp(kThinnestShare * size, 0.0, kMinimumThickness);
  }
  in.drag.emplace(Parts::Drag{ProbeDrag(probe, *in.hovered, view.axes(), view.ray(pixel), thinnest), probe, pixel,
                              pixel, pixel, false, std::nullopt});
  if (in.probe) in.drag->before.emplace(in.probe);
  return true;
}

std::optional<Probe> vtkReflectionProbeRepresentation::Pull(const ViewProjection& view, const glm::dvec2& pixel) {
  Parts& in = *this->Inside;
  if (!in.drag) return std::nullopt;
  Parts::Drag& drag = *in.drag;
  drag.held += (this->Fine ? kFineShare : 1.0) * (pixel - drag.pixel);
  drag.pixel = pixel;
  if (!drag.moved && glm::length(pixel - drag.pressed) < kClickPixels) return std::nullopt;
  drag.moved = true;
  const Handle& handle = drag.drag.handle();
  DragWish wish{view.ray(drag.held), this->Symmetric, std::nullopt, nullptr};
  if (this->ConstrainedAxis >= 0) wish.axis = this->ConstrainedAxis;
  std::optional<DragSnap> snap;
  if (this->Snapping) {
    const SurfaceRays* surfaces = nullptr;
    if (isFace(handle) && this->SnapToSurfaces) {
      if (!in.surfaces && !in.actorSurfaces) in.actorSurfaces = std::make_unique<ActorSurfaces>(this->Renderer);
      surfaces = in.surfaces ? in.surfaces() : in.actorSurfaces.get();
    }
    const SnapSettings settings{this->SnapDistance, this->LargestGridStep, this->AngleStep};
    snap.emplace(surfaces, view.ray(pixel), view.metresPerPixel(handleAnchorWorld(drag.now, handle)), settings);
    wish.snap = &*snap;
  }
  drag.now = drag.drag.at(wish);
  const ReadoutStyle style{this->LengthUnit, in.words};
  in.readout = handleReadout(handle, drag.drag.start(), drag.now, style);
  if (snap) in.readout += "\n" + snapReadout(*snap, handle, style);
  return drag.now;
}

void vtkReflectionProbeRepresentation::LetGo() {
  Parts& in = *this->Inside;
  in.drag.reset();
  in.actorSurfaces.reset();
  in.readout.clear();
}

const ProbeDrag* vtkReflectionProbeRepresentation::GetDrag() const {
  return this->Inside->drag ? &this->Inside->drag->drag : nullptr;
}

void vtkReflectionProbeRepresentation::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  const auto color = [&os, indent](const char* name, const double* c) {
    os << indent << name << ": " << c[0] << " " << c[1] << " " << c[2] << "\n";
  };
  os << indent << "Probe: " << this->Inside->probe.Get() << "\n";
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "Symmetric: " << this->Symmetric << "\n";
  os << indent << "Fine: " << this->Fine << "\n";
  os << indent << "Snapping: " << this->Snapping << "\n";
  os << indent << "ConstrainedAxis: " << this->ConstrainedAxis << "\n";
  os << indent << "SnapToSurfaces: " << this->SnapToSurfaces << "\n";
  os << indent << "SnapDistance: " << this->SnapDistance << "\n";
  os << indent << "LargestGridStep: " << this->LargestGridStep << "\n";
  os << indent << "AngleStep: " << this->AngleStep << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  color("XAxisColor", this->XAxisColor);
  color("YAxisColor", this->YAxisColor);
  color("ZAxisColor", this->ZAxisColor);
  color("BoxColor", this->BoxColor);
  color("InfluenceColor", this->InfluenceColor);
  color("BlendColor", this->BlendColor);
  color("OriginColor", this->OriginColor);
  color("HaloColor", this->HaloColor);
  os << indent << "ReadoutVisibility: " << this->ReadoutVisibility << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "Readout: " << this->Inside->readout << "\n";
}
