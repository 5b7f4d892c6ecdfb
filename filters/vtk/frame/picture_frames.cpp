#include "filters/vtk/frame/picture_frames.h"

#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>

#include <algorithm>

#include "filters/vtk/scene/vtkCulledRenderer.h"

namespace boxprobe {

namespace {

// The same object still, or both none: an address alone may have been used again.
template <typename T>
bool sameOwner(const std::weak_ptr<T>& a, const std::weak_ptr<T>& b) {
  return !a.owner_before(b) && !b.owner_before(a);
}

}  // namespace

PictureFrames::PictureFrames(vtkOpenGLRenderWindow* window, vtkCulledRenderer* renderer,
                             std::shared_ptr<DrawState> state, const SceneContent* content)
    : window_(window), renderer_(renderer), state_(std::move(state)), content_(content) {}

bool PictureFrames::Key::operator==(const Key& o) const {
  return generation == o.generation && camera == o.camera && size == o.size &&
         std::equal(bindings.begin(), bindings.end(), o.bindings.begin(), o.bindings.end(),
                    sameOwner<const ProbeBinding>) &&
         std::equal(maps.begin(), maps.end(), o.maps.begin(), o.maps.end(), sameOwner<const ProbeMaps>) &&
         std::equal(lattices.begin(), lattices.end(), o.lattices.begin(), o.lattices.end(),
                    sameOwner<const DiffuseLattice>);
}

const ProbeBinding* PictureFrames::drawn(const DrawnObject& object) const {
  return object.settings.visible ? object.pass->GetDrawnBinding() : nullptr;
}

int PictureFrames::raysAFrame() const {
  int rays = 0;
  for (const DrawnObject& object : content_->objects) {
    if (const ProbeBinding* binding = drawn(object)) rays = std::max(rays, binding->animatedSamples());
  }
  return rays;
}

int PictureFrames::blurredRays() const {
  int rays = 0;
  for (const DrawnObject& object : content_->objects) {
    if (const ProbeBinding* binding = drawn(object)) rays = std::max(rays, binding->blurredSamples());
  }
  return rays;
}

// Not where the renderer culls objects itself, which it does only without a pass: they would be missing.
bool PictureFrames::looksBehind() const {
  if (content_->many) return false;
  return std::any_of(content_->objects.begin(), content_->objects.end(),
                     [](const DrawnObject& object) { return object.settings.visible && object.pass->LooksBehind(); });
}

int PictureFrames::wanted() const {
  const int rays = raysAFrame();
  return rays == 0 ? 0 : limit_.value_or(framesWanted(rays));
}

FrameCount PictureFrames::count() const {
  FrameCount count;
  count.wanted = plain_ ? 0 : wanted();
  if (count.wanted > 0 && active_) count.averaged = std::min(screen_->GetFrames(), count.wanted);
  return count;
}

PictureFrames::Key PictureFrames::key() const {
  Key key;
  key.generation = generation_;
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->GetPosition(&key.camera[0]);
  camera->GetFocalPoint(&key.camera[3]);
  camera->GetViewUp(&key.camera[6]);
  key.camera[9] = camera->GetViewAngle();
  key.camera[10] = camera->GetParallelProjection();
  key.camera[11] = camera->GetParallelScale();
  const int* size = window_->GetSize();
  key.size = {size[0], size[1], window_->GetMultiSamples()};
  for (const DrawnObject& object : content_->objects) {
    if (!object.settings.visible) continue;
    // The binding that was set, not the one drawn: a cheaper picture in between leaves this one as it is.
    key.bindings.push_back(object.pass->GetSharedBinding());
    const ProbeBinding* binding = object.pass->GetBinding();
    if (binding == nullptr) continue;
    for (const auto& probe : binding->probes) {
      key.maps.push_back(probe->maps);
      // A frame that does not wait for a lattice is followed by frames with it.
      if (state_->resources.latticesBeside) key.lattices.push_back(probe->latticeBefore);
    }
  }
  key.maps.push_back(state_->resources.sky);
  return key;
}

vtkSmartPointer<vtkPicturePass> PictureFrames::makePass() const {
  auto pass = vtkSmartPointer<vtkPicturePass>::New();
  pass->SetDrawState(state_);
  return pass;
}

void PictureFrames::beginFrame(bool plain) {
  const int frames = wanted();
  plain_ = plain;
  const int rays = plain ? 0 : blurredRays();
  const bool behind = !plain && looksBehind();
  active_ = !plain && (frames > 0 || rays > 0 || behind);
  for (const DrawnObject& object : content_->objects) object.pass->SetSeparateSpecular(rays > 0);
  if (!active_) {
    if (screen_) renderer_->SetPass(nullptr);
    return;
  }
  if (!screen_) screen_ = makePass();
  Key now = key();
  // A picture that nothing averages is drawn whenever it is asked for, as without the pass.
  if (!(now == shown_) || (frames == 0 && rays == 0)) {
    screen_->Restart();
    shown_ = std::move(now);
  }
  screen_->Props = content_->shownProps(renderer_);
  screen_->Props.push_back(content_->sky);
  screen_->Sky = content_->sky;
  screen_->BlurredRays = rays;
  screen_->Behind = behind;
  screen_->Width = shown_.size[0];
  screen_->Height = shown_.size[1];
  screen_->Samples = shown_.size[2];
  screen_->Limit = std::max(frames, 1);
  renderer_->SetPass(screen_);
}

vtkPicturePass* PictureFrames::linearPass(int frames) {
  const int rays = blurredRays();
  for (const DrawnObject& object : content_->objects) object.pass->SetSeparateSpecular(rays > 0);
  const bool behind = looksBehind();
  if (rays == 0 && (frames <= 1 || !averages()) && !behind) return nullptr;
  if (!linear_) linear_ = makePass();
  linear_->Restart();
  linear_->Limit = averages() ? frames : 1;
  linear_->BlurredRays = rays;
  linear_->Behind = behind;
  linear_->Sky = content_->sky;
  return linear_;
}

void PictureFrames::releaseLinear() {
  if (linear_) linear_->ReleaseTargets();
}

void PictureFrames::release() {
  renderer_->SetPass(nullptr);
  active_ = false;
  for (const auto& pass : {screen_, linear_}) {
    if (pass) pass->ReleaseGraphicsResources(window_);
  }
}

}  // namespace boxprobe
