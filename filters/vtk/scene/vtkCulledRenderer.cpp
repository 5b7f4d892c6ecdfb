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

void vtkCulledRenderer::SetCulledProps(std::vector<vtkProp*> props, std::vector<boxprobe::Box> bounds) {
  this->Culled = std::move(props);
  this->Tree = boxprobe::BoxTree(bounds);
  this->SetDrawn({});
  this->DrawnHolds = false;
}

void vtkCulledRenderer::SetCulling(bool culling) {
  this->Culling = culling;
  this->DrawnHolds = false;
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
void vtkCulledRenderer::DrawOpaqueActors(vtkFrameBufferObjectBase* fbo) {
  vtkProp** given = this->PropArray;
  double eye[3];
  this->GetActiveCamera()->GetPosition(eye);
  std::vector<std::pair<double, vtkProp*>> actors;
  for (int i = 0; i < this->PropArrayCount && mayBeReordered(given[i]); ++i) {
    const double* b = given[i]->GetBounds();
    double squared = 0.0;
    for (int axis = 0; b != nullptr && axis < 3; ++axis) {
      const double away = std::max(std::abs(b[2 * axis] - eye[axis]), std::abs(b[2 * axis + 1] - eye[axis]));
      squared += away * away;
    }
    actors.emplace_back(squared, given[i]);
  }
  std::stable_sort(actors.begin(), actors.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<vtkProp*> ordered(given, given + this->PropArrayCount);
  for (std::size_t i = 0; i < actors.size(); ++i) {
    ordered[i] = actors[i].second;
  }
  this->PropArray = ordered.data();
  this->Superclass::DeviceRenderOpaqueGeometry(fbo);
  this->PropArray = given;
}

void vtkCulledRenderer::DrawOpaque(const std::vector<std::size_t>& items) {
  this->Array.clear();
  for (const std::size_t item : items) {
    this->Array.push_back(this->Culled[item]);
  }
  this->PropArray = this->Array.data();
  this->PropArrayCount = static_cast<int>(this->Array.size());
  this->NearestFirst ? this->DrawOpaqueActors(nullptr) : this->Superclass::DeviceRenderOpaqueGeometry();
}

void vtkCulledRenderer::DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* fbo) {
  if (this->Culled.empty()) {
    this->NearestFirst ? this->DrawOpaqueActors(fbo) : this->Superclass::DeviceRenderOpaqueGeometry(fbo);
    return;
  }
  const View view = this->CurrentView();
  if (!this->Culling) {
    std::vector<std::size_t> all(this->Culled.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    this->DrawOpaque(all);
    this->SetDrawn(std::move(all));
  } else if (this->DrawnHolds && view == this->DrawnView) {
    this->DrawOpaque(this->Drawn);
  } else {
    this->FindVisible();
    this->DrawnView = view;
    this->DrawnHolds = true;
  }
  this->Array = this->Others;
  this->PropArray = this->Array.data();
  this->PropArrayCount = static_cast<int>(this->Array.size());
  this->Superclass::DeviceRenderOpaqueGeometry(fbo);
  // For what comes after the opaque: the translucent and the overlays.
  this->Array.clear();
  for (const std::size_t item : this->Drawn) {
    this->Array.push_back(this->Culled[item]);
  }
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
    this->DrawOpaque(batch);
    all.insert(all.end(), batch.begin(), batch.end());
    batch = this->Unhidden(drawn);
    nearestFirst(batch);
    batch.resize(std::min(batch.size(), most));
    most *= 2;
  }
  // Drawn before what hides it was: not the next time.
  std::vector<boxprobe::Box> boxes;
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
  this->DrawnHolds = false;
  this->Superclass::ReleaseGraphicsResources(window);
}
