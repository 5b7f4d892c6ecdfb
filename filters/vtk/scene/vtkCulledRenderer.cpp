#include "filters/vtk/scene/vtkCulledRenderer.h"

#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "filters/vtk/gl/opengl.h"
#include "filters/vtk/scene/visible_search.h"
#include "filters/vtk/surface/vtkProbeActor.h"

vtkStandardNewMacro(vtkCulledRenderer);

namespace {

// Glass must be drawn after everything that is seen through it, including the sky.
bool mayBeReordered(vtkProp* prop) {
  auto* actor = vtkProbeActor::SafeDownCast(prop);
  return actor != nullptr && !actor->GetPass()->DrawsGlass();
}

}  // namespace

vtkCulledRenderer::vtkCulledRenderer() = default;
vtkCulledRenderer::~vtkCulledRenderer() = default;

void vtkCulledRenderer::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Culled: " << this->Drawn.size() << " of " << this->Culled.size() << " drawn\n";
}

void vtkCulledRenderer::SetCulledProps(std::vector<vtkProp*> props, const std::vector<boxprobe::Box>& bounds) {
  this->Culled = std::move(props);
  this->Tree = boxprobe::BoxTree(bounds);
  this->SetDrawn({});
  this->DrawnHolds = false;
}

void vtkCulledRenderer::SetCulling(bool culling) {
  this->Culling = culling;
  this->DrawnHolds = false;
}

void vtkCulledRenderer::SetBackdrop(vtkProp* backdrop) {
  this->Backdrop = backdrop;
  this->Still.forget();
}

void vtkCulledRenderer::SetHiddenCulling(bool culling) {
  this->HiddenCulling = culling;
  this->Still.forget();
}

void vtkCulledRenderer::SetDrawn(std::vector<std::size_t> items) {
  std::sort(items.begin(), items.end());
  if (items == this->Drawn) {
    return;
  }
  this->Drawn = std::move(items);
  ++this->DrawnGeneration;
}

vtkCulledRenderer::View vtkCulledRenderer::CurrentView() {
  View view{};
  vtkCamera* camera = this->GetActiveCamera();
  camera->GetPosition(&view[0]);
  camera->GetFocalPoint(&view[3]);
  camera->GetViewUp(&view[6]);
  view[9] = camera->GetViewAngle();
  view[10] = camera->GetParallelProjection() ? camera->GetParallelScale() : -1.0;
  const int* size = this->GetSize();
  view[11] = size[0];
  view[12] = size[1];
  view[13] = this->RenderWindow != nullptr ? this->RenderWindow->GetMultiSamples() : 0;
  return view;
}

std::vector<std::size_t> vtkCulledRenderer::InView() {
  return boxprobe::VisibleSearch(this, this->Tree, this->Test, this->BoxesAsked).inView();
}

// The superclass draws opaque props through DeviceRenderOpaqueGeometry below, which determines the visible ones; it
// then uses the resulting list for everything else.
int vtkCulledRenderer::UpdateGeometry(vtkFrameBufferObjectBase* fbo) {
  if (this->Culled.empty() || this->Selector != nullptr) {
    return this->Superclass::UpdateGeometry(fbo);
  }
  vtkProp** array = this->PropArray;
  const int count = this->PropArrayCount;
  this->Others.assign(array, array + count);
  const int rendered = this->Superclass::UpdateGeometry(fbo);
  this->PropArray = array;
  this->PropArrayCount = count;
  return rendered;
}

// By the farthest point of their bounds: a room around the eye and everything else then comes last. Only for this pass,
// because translucent props are blended in a separate order.
std::vector<vtkProp*> vtkCulledRenderer::Ordered(const std::vector<vtkProp*>& given) {
  double eye[3];
  this->GetActiveCamera()->GetPosition(eye);
  std::vector<std::pair<double, vtkProp*>> actors;
  for (std::size_t i = 0; this->NearestFirst && i < given.size() && mayBeReordered(given[i]); ++i) {
    const double* b = given[i]->GetBounds();
    double squared = 0.0;
    for (std::size_t axis = 0; b != nullptr && axis < 3; ++axis) {
      const double away = std::max(std::abs(b[2 * axis] - eye[axis]), std::abs(b[2 * axis + 1] - eye[axis]));
      squared += away * away;
    }
    actors.emplace_back(squared, given[i]);
  }
  std::stable_sort(actors.begin(), actors.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<vtkProp*> ordered = given;
  for (std::size_t i = 0; i < actors.size(); ++i) {
    ordered[i] = actors[i].second;
  }
  return ordered;
}

void vtkCulledRenderer::Draw(std::vector<vtkProp*> props, vtkFrameBufferObjectBase* fbo) {
  vtkProp** given = this->PropArray;
  const int count = this->PropArrayCount;
  this->PropArray = props.data();
  this->PropArrayCount = static_cast<int>(props.size());
  this->Superclass::DeviceRenderOpaqueGeometry(fbo);
  this->PropArray = given;
  this->PropArrayCount = count;
}

// VTK enables blending for all draws. Opaque objects do not need it, and on software renderers it is expensive.
void vtkCulledRenderer::DrawSurfaces(const std::vector<vtkProp*>& props, vtkFrameBufferObjectBase* fbo) {
  const auto other = std::find_if_not(props.begin(), props.end(), mayBeReordered);
  {
    vtkOpenGLState* state = vtkOpenGLRenderWindow::SafeDownCast(this->RenderWindow)->GetState();
    const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    state->vtkglDisable(GL_BLEND);
    this->Draw({props.begin(), other}, fbo);
  }
  if (other != props.end()) {
    this->Draw({other, props.end()}, fbo);
  }
}

// Draws the backdrop only where it is visible: with several samples per pixel, software renderers also shade hidden
// fragments.
void vtkCulledRenderer::DrawOthers(const std::vector<vtkProp*>& props, vtkFrameBufferObjectBase* fbo) {
  const auto backdrop = std::find(props.begin(), props.end(), this->Backdrop);
  this->Draw({props.begin(), backdrop}, fbo);
  if (backdrop == props.end()) {
    return;
  }
  {
    vtkOpenGLState* state = vtkOpenGLRenderWindow::SafeDownCast(this->RenderWindow)->GetState();
    const vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    const vtkOpenGLState::ScopedglScissor box(state);
    const boxprobe::OcclusionQuery::Rectangle& shows = this->BackdropRectangle;
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(shows.x, shows.y, shows.width, shows.height);
    this->Draw({backdrop, backdrop + 1}, fbo);
  }
  this->Draw({backdrop + 1, props.end()}, fbo);
}

std::vector<vtkProp*> vtkCulledRenderer::Showing(const std::vector<vtkProp*>& props) {
  std::vector<vtkProp*> showing;
  for (vtkProp* prop : props) {
    if (!this->Still.hides(prop)) {
      showing.push_back(prop);
      continue;
    }
    ++this->CulledCount;
    this->BackdropCulled = this->BackdropCulled || prop == this->Backdrop;
  }
  return showing;
}

// Tests boxes against the depth of the surfaces. Queries boxes instead of draws: software renderers compile a second
// program for draws whose samples are counted.
void vtkCulledRenderer::FindHidden(const std::vector<vtkProp*>& surfaces, bool backdrop) {
  std::vector<boxprobe::Box> boxes;
  std::vector<vtkProp*> asked;
  for (vtkProp* prop : surfaces) {
    const double* b = prop->GetBounds();
    if (b == nullptr || b[0] > b[1]) {
      continue;
    }
    asked.push_back(prop);
    boxes.push_back({{b[0], b[2], b[4]}, {b[1], b[3], b[5]}});
  }
  const std::vector<bool> visible = this->Test.visible(this, boxes);
  std::unordered_set<vtkProp*> hidden;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (!visible[i]) {
      hidden.insert(asked[i]);
    }
  }
  if (backdrop) {
    this->BackdropRectangle = this->Test.farthestShows(this);
    if (this->BackdropRectangle.width == 0) {
      hidden.insert(this->Backdrop);
    }
  }
  this->Still.set(std::move(hidden));
}

// Only surfaces count as occluders: what other props cover may change without notice.
void vtkCulledRenderer::DrawStill(const std::vector<vtkProp*>& surfaces, const std::vector<vtkProp*>& others,
                                  vtkFrameBufferObjectBase* fbo) {
  const bool backdrop = std::find(others.begin(), others.end(), this->Backdrop) != others.end();
  bool asks = false;
  if (this->HiddenCulling && this->PreserveDepthBuffer == 0) {
    std::vector<vtkProp*> concerned = surfaces;
    if (backdrop) {
      concerned.push_back(this->Backdrop);
    }
    asks = this->Still.begin(this, concerned);
  } else {
    this->Still.forget();
  }
  this->DrawSurfaces(this->Showing(surfaces), fbo);
  if (asks) {
    // Culled props have already been queried when the visible ones were determined.
    this->FindHidden(this->Culled.empty() ? surfaces : std::vector<vtkProp*>(), backdrop);
  }
  if (asks || !this->Still.known()) {
    this->Draw(others, fbo);
  } else {
    this->DrawOthers(this->Showing(others), fbo);
  }
}

std::vector<vtkProp*> vtkCulledRenderer::PropsOf(const std::vector<std::size_t>& items) const {
  std::vector<vtkProp*> props;
  props.reserve(items.size());
  for (const std::size_t item : items) {
    props.push_back(this->Culled[item]);
  }
  return props;
}

void vtkCulledRenderer::DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* fbo) {
  this->CulledCount = 0;
  this->BackdropCulled = false;
  if (this->Culled.empty()) {
    const std::vector<vtkProp*> given(this->PropArray, this->PropArray + this->PropArrayCount);
    const std::vector<vtkProp*> ordered = this->Ordered(given);
    // VTK's own passes that the superclass runs need all props at once.
    if (this->UseHiddenLineRemoval != 0 || this->UseSSAO) {
      this->Still.forget();
      this->Draw(ordered, fbo);
      return;
    }
    const auto other = std::find_if_not(ordered.begin(), ordered.end(), mayBeReordered);
    this->DrawStill({ordered.begin(), other}, {other, ordered.end()}, fbo);
    return;
  }
  const View view = this->CurrentView();
  if (!this->Culling) {
    std::vector<std::size_t> all(this->Culled.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    this->Still.forget();
    this->DrawSurfaces(this->Ordered(this->PropsOf(all)));
    this->SetDrawn(std::move(all));
    this->Draw(this->Others, fbo);
  } else if (this->DrawnHolds && view == this->DrawnView) {
    this->DrawStill(this->Ordered(this->PropsOf(this->Drawn)), this->Others, fbo);
  } else {
    this->Still.forget();
    boxprobe::VisibleSearch search(this, this->Tree, this->Test, this->BoxesAsked);
    this->SetDrawn(search.run(this->Drawn, [this](const std::vector<std::size_t>& items) {
      this->DrawSurfaces(this->Ordered(this->PropsOf(items)));
    }));
    this->DrawnView = view;
    this->DrawnHolds = true;
    this->Draw(this->Others, fbo);
  }
  // For what follows the opaque pass: translucent props and overlays.
  this->Array = this->PropsOf(this->Drawn);
  this->Array.insert(this->Array.end(), this->Others.begin(), this->Others.end());
  this->PropArray = this->Array.data();
  this->PropArrayCount = static_cast<int>(this->Array.size());
}

void vtkCulledRenderer::ReleaseGraphicsResources(vtkWindow* window) {
  this->Test.release();
  this->Still.forget();
  this->DrawnHolds = false;
  this->Superclass::ReleaseGraphicsResources(window);
}
