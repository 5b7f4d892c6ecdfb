#include "filters/vtk/scene/vtkCulledRenderer.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "filters/vtk/scene/view_frustum.h"
#include "filters/vtk/surface/vtkProbePolyDataMapper.h"

vtkStandardNewMacro(vtkCulledRenderer);

namespace {

// Glass comes after all that is seen through it, the sky included.
bool mayBeReordered(vtkProp* prop) {
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* mapper = actor != nullptr ? vtkProbePolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  return mapper != nullptr && !mapper->DrawsGlass();
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

void vtkCulledRenderer::SetLeavingOut(bool leavingOut) {
  this->LeavingOut = leavingOut;
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
  const boxprobe::ViewFrustum frustum(this->GetActiveCamera(), this->GetTiledAspectRatio());
  std::vector<std::size_t> items;
  this->Tree.search([&](const boxprobe::Box& box) { return frustum.meets(box); },
                    [&](std::size_t item) { items.push_back(item); });
  std::sort(items.begin(), items.end());
  return items;
}

// The superclass draws the opaque ones by way of DeviceRenderOpaqueGeometry below, which finds out which those are;
// what else there is to do it does with the list as that leaves it.
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

// By the farthest point of their bounds: a room that holds the eye and all the rest then comes last. Only for this
// pass, because translucent props are blended in their own order.
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

std::vector<vtkProp*> vtkCulledRenderer::Showing(const std::vector<vtkProp*>& props) {
  std::vector<vtkProp*> showing;
  for (vtkProp* prop : props) {
    if (!this->Still.hides(prop)) {
      showing.push_back(prop);
      continue;
    }
    ++this->LeftOut;
    this->BackdropLeftOut = this->BackdropLeftOut || prop == this->Backdrop;
  }
  return showing;
}

// Past what the surfaces left in the depth buffer. Asked for their boxes, not while they are drawn: software renderers
// compile every program again for a draw that counts its samples.
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
  if (backdrop && !this->Test.farthestVisible(this)) {
    hidden.insert(this->Backdrop);
  }
  this->Still.set(std::move(hidden));
}

// Only surfaces hide anything: of what else there is, what it covers may change without a word.
void vtkCulledRenderer::DrawStill(const std::vector<vtkProp*>& surfaces, const std::vector<vtkProp*>& others,
                                  vtkFrameBufferObjectBase* fbo) {
  const bool backdrop = std::find(others.begin(), others.end(), this->Backdrop) != others.end();
  bool asks = false;
  if (this->LeavingOut && this->PreserveDepthBuffer == 0) {
    std::vector<vtkProp*> concerned = surfaces;
    if (backdrop) {
      concerned.push_back(this->Backdrop);
    }
    asks = this->Still.begin(this, concerned);
  } else {
    this->Still.forget();
  }
  this->Draw(this->Showing(surfaces), fbo);
  if (asks) {
    // Those that are culled have been asked for already, when it was found out which of them are seen.
    this->FindHidden(this->Culled.empty() ? surfaces : std::vector<vtkProp*>(), backdrop);
  }
  this->Draw(asks ? others : this->Showing(others), fbo);
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
  this->LeftOut = 0;
  this->BackdropLeftOut = false;
  if (this->Culled.empty()) {
    const std::vector<vtkProp*> given(this->PropArray, this->PropArray + this->PropArrayCount);
    const std::vector<vtkProp*> ordered = this->Ordered(given);
    // Passes of VTK's own that the superclass runs want all props at once.
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
    this->Draw(this->Ordered(this->PropsOf(all)));
    this->SetDrawn(std::move(all));
    this->Draw(this->Others, fbo);
  } else if (this->DrawnHolds && view == this->DrawnView) {
    this->DrawStill(this->Ordered(this->PropsOf(this->Drawn)), this->Others, fbo);
  } else {
    this->Still.forget();
    this->FindVisible();
    this->DrawnView = view;
    this->DrawnHolds = true;
    this->Draw(this->Others, fbo);
  }
  // For what comes after the opaque: the translucent and the overlays.
  this->Array = this->PropsOf(this->Drawn);
  this->Array.insert(this->Array.end(), this->Others.begin(), this->Others.end());
  this->PropArray = this->Array.data();
  this->PropArrayCount = static_cast<int>(this->Array.size());
}

// Those not drawn yet that are in the view and not hidden by what has been drawn: branches of the tree are asked for
// level by level, all of a level at once.
std::vector<std::size_t> vtkCulledRenderer::Unhidden(const std::vector<char>& drawn) {
  const boxprobe::ViewFrustum frustum(this->GetActiveCamera(), this->GetTiledAspectRatio());
  std::vector<std::size_t> found;
  std::vector<int> open = {0};
  while (!open.empty()) {
    std::vector<int> inView;
    std::vector<boxprobe::Box> boxes;
    for (const int index : open) {
      const auto& node = this->Tree.nodes()[static_cast<std::size_t>(index)];
      if (frustum.meets(node.bounds)) {
        inView.push_back(index);
        boxes.push_back(node.bounds);
      }
    }
    const std::vector<bool> visible = this->Test.visible(this, boxes);
    this->BoxesAsked += boxes.size();
    open.clear();
    std::vector<std::size_t> items;
    std::vector<boxprobe::Box> itemBoxes;
    for (std::size_t i = 0; i < inView.size(); ++i) {
      if (!visible[i]) {
        continue;
      }
      const auto& node = this->Tree.nodes()[static_cast<std::size_t>(inView[i])];
      if (node.left >= 0) {
        open.push_back(node.left);
        open.push_back(node.right);
        continue;
      }
      for (int k = node.first; k < node.first + node.count; ++k) {
        const std::size_t item = this->Tree.items()[static_cast<std::size_t>(k)];
        if (drawn[item] == 0 && frustum.meets(this->Tree.box(item))) {
          items.push_back(item);
          itemBoxes.push_back(this->Tree.box(item));
        }
      }
    }
    const std::vector<bool> seen = this->Test.visible(this, itemBoxes);
    this->BoxesAsked += itemBoxes.size();
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (seen[i]) {
        found.push_back(items[i]);
      }
    }
  }
  return found;
}

void vtkCulledRenderer::FindVisible() {
  double eye[3];
  this->GetActiveCamera()->GetPosition(eye);
  const glm::dvec3 position(eye[0], eye[1], eye[2]);
  const auto nearestFirst = [&](std::vector<std::size_t>& items) {
    const auto distance = [&](std::size_t item) {
      const boxprobe::Box& box = this->Tree.box(item);
      const glm::dvec3 away = glm::max(glm::max(box.min - position, position - box.max), glm::dvec3(0.0));
      return glm::dot(away, away);
    };
    std::stable_sort(items.begin(), items.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  };
  std::vector<char> drawn(this->Culled.size(), 0);
  const boxprobe::ViewFrustum frustum(this->GetActiveCamera(), this->GetTiledAspectRatio());
  // What the last frame showed is most of what this one shows.
  std::vector<std::size_t> batch, all;
  for (const std::size_t item : this->Drawn) {
    if (frustum.meets(this->Tree.box(item))) {
      batch.push_back(item);
    }
  }
  std::size_t most = 16;  // nearest first, few at a time: what is near hides most; the more the later, so that it ends
  if (batch.empty()) {
    batch = this->InView();
    nearestFirst(batch);
    batch.resize(std::min(batch.size(), most));
  }
  while (!batch.empty()) {
    for (const std::size_t item : batch) {
      drawn[item] = 1;
    }
    this->Draw(this->Ordered(this->PropsOf(batch)));
    all.insert(all.end(), batch.begin(), batch.end());
    batch = this->Unhidden(drawn);
    nearestFirst(batch);
    batch.resize(std::min(batch.size(), most));
    most *= 2;
  }
  // Drawn before what hides it was: not the next time.
  std::vector<boxprobe::Box> boxes;
  boxes.reserve(all.size());
  for (const std::size_t item : all) {
    boxes.push_back(this->Tree.box(item));
  }
  const std::vector<bool> seen = this->Test.visible(this, boxes);
  this->BoxesAsked += boxes.size();
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (seen[i]) {
      kept.push_back(all[i]);
    }
  }
  this->SetDrawn(std::move(kept));
}

void vtkCulledRenderer::ReleaseGraphicsResources(vtkWindow* window) {
  this->Test.release();
  this->Still.forget();
  this->DrawnHolds = false;
  this->Superclass::ReleaseGraphicsResources(window);
}
