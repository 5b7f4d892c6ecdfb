#include "filters/vtk/frame/picture_frames.h"

#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>

#include <algorithm>

#include "filters/vtk/scene/vtkCulledRenderer.h"

namespace boxprobe {

namespace {

// The same object, or both empty: an address alone might have been reused.
template <typename T>
bool sameOwner(const std::weak_ptr<T>& a, const std::weak_ptr<T>& b) {
  return !a.owner_before(b) && !b.owner_before(a);
}

// The number of lobe rays whose error a technique's frame matches.
int raysWorth(const Technique& technique) {
  const std::string_view id = evaluationRows()[static_cast<std::size_t>(technique.evaluation)].id;
  return id == "footprint8" || id == "footprint16" ? 64 : id == "footprint4" ? 16 : 4;
}

}  // namespace

PictureFrames::PictureFrames(vtkOpenGLRenderWindow* window, vtkCulledRenderer* renderer,
                             std::shared_ptr<DrawState> state, const SceneContent* content)
    : window_(window),
      renderer_(renderer),
      state_(std::move(state)),
      content_(content),
      props_([content, renderer] {
        std::vector<vtkProp*> props = content->shownProps(renderer);
        props.push_back(content->sky);
        return props;
      }),
      sky_(content->sky) {}

PictureFrames::PictureFrames(vtkRenderer* renderer, std::shared_ptr<DrawState> state, const SceneContent* content,
                             std::function<std::vector<vtkProp*>()> props)
    : window_(nullptr), renderer_(renderer), state_(std::move(state)), content_(content), props_(std::move(props)) {}

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

// Not if the renderer culls objects itself, which it only does without a pass: they would be missing.
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
  if (refining_ && !plain_) {
    count.refined = true;
    count.wanted = stages_.framesInAll();
    count.averaged =
        guessing_ ? screen_->GetFrames() : stages_.framesBefore() + (stages_.more() ? screen_->GetFrames() : 0);
    if (stopped_) count.wanted = count.averaged;
    return count;
  }
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
  // vtkWindowToImageFilter sets it anew, by a sine and back: its last bit may differ.
  key.camera[9] = static_cast<float>(camera->GetViewAngle());
  key.camera[10] = camera->GetParallelProjection();
  key.camera[11] = camera->GetParallelScale();
  camera->GetWindowCenter(&key.camera[12]);
  if (sky_ != nullptr) {
    const int* size = window_->GetSize();
    key.size = {size[0], size[1], window_->GetMultiSamples(), 0, 0};
  } else {
    renderer_->GetTiledSizeAndOrigin(&key.size[0], &key.size[1], &key.size[3], &key.size[4]);
    key.size[2] = window_->GetMultiSamples();
  }
  for (const DrawnObject& object : content_->objects) {
    if (!object.settings.visible) continue;
    // The binding that was set, not the one drawn: a cheaper picture in between does not invalidate this one.
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

void PictureFrames::setRays(RefinedRays rays) {
  for (const DrawnObject& object : content_->objects) object.pass->SetRefined(rays);
}

void PictureFrames::dropRays() {
  setRays({});
}

void PictureFrames::refine(const RefineSettings& settings) {
  if (settings == settings_) return;
  settings_ = settings;
  refining_ = tried_ = false;
  shown_ = {};
  dropRays();
}

int PictureFrames::firstGuess() const {
  int worth = 0;
  for (const DrawnObject& object : content_->objects) {
    const ProbeBinding* binding = object.settings.visible ? object.pass->GetBinding() : nullptr;
    if (binding == nullptr || binding->probes.empty()) continue;
    for (std::size_t slot = 0; slot < binding->probes.size(); ++slot) {
      const int of = raysWorth(binding->technique(slot));
      worth = worth == 0 ? of : std::min(worth, of);
    }
  }
  return worth;
}

void PictureFrames::beginRefinement(vtkPicturePass* pass, const RefineSettings& settings) {
  const int worth = firstGuess();
  stages_.begin(worth > 0 ? settings : RefineSettings{}, worth);
  guessing_ = true;
  stopped_ = false;
  begun_ = std::chrono::steady_clock::now();
  setRays({});
  pass->Restart();
  pass->Limit = 1;
  pass->Share = [this](int frames) { return stages_.share(frames); };
}

bool PictureFrames::outOfTime() const {
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begun_;
  return stages_.settings().seconds > 0.0 && since.count() > stages_.settings().seconds;
}

// Decides, before a frame, what it draws. False if there is nothing to add.
bool PictureFrames::advance(vtkPicturePass* pass, bool hold) {
  const int frames = pass->GetFrames();
  if (frames > 0 && stages_.more() && outOfTime()) stopped_ = true;
  if (stopped_) {
    pass->Limit = frames;
    return false;
  }
  const int wanted = guessing_ ? 1 : stages_.frames();
  if (frames > 0 && hold) {
    pass->Limit = frames;
    return false;
  }
  if (frames >= wanted && stages_.more()) {
    if (!guessing_) {
      const double exposure = state_->exposure();
      stages_.endStage(pass->GetChange(window_, exposure), pass->GetChangeWithin(window_, exposure));
    }
    guessing_ = false;
    if (stages_.more()) pass->Promote();
  }
  if (!guessing_ && stages_.more() && frames == stages_.framesOfPart() && frames < stages_.frames()) {
    pass->KeepPart(window_);
  }
  if (!guessing_) setRays(stages_.rays());
  pass->Limit = guessing_ ? 1 : stages_.more() ? stages_.frames() : std::max(frames, 1);
  return pass->GetFrames() < pass->Limit;
}

// Draws the picture through the pass, in the window.
void PictureFrames::show(int rays, bool behind) {
  screen_->Props = props_();
  screen_->Culled = content_->many;
  screen_->Sky = sky_;
  screen_->Over = sky_ == nullptr;
  screen_->BlurredRays = rays;
  screen_->Behind = behind;
  screen_->Width = shown_.size[0];
  screen_->Height = shown_.size[1];
  screen_->Samples = shown_.size[2];
  screen_->X = shown_.size[3];
  screen_->Y = shown_.size[4];
  renderer_->SetPass(screen_);
}

void PictureFrames::endFrame() {
  if (screen_ && renderer_->GetPass() == screen_.Get()) renderer_->SetPass(nullptr);
}

void PictureFrames::beginFrame(bool plain, bool hold) {
  plain_ = plain;
  if (settings_.rays > 0 && !plain) {
    Key now = key();
    if (!(now == shown_) || !tried_) {
      shown_ = std::move(now);
      tried_ = true;
      refining_ = firstGuess() > 0;
      if (refining_) {
        if (!screen_) screen_ = makePass();
        beginRefinement(screen_, settings_);
      }
    }
    if (refining_) {
      active_ = true;
      const bool behind = looksBehind();
      for (const DrawnObject& object : content_->objects) object.pass->SetSeparateSpecular(false);
      advance(screen_, hold);
      return show(0, behind);
    }
  } else if (refining_) {
    refining_ = tried_ = false;
    shown_ = {};
    dropRays();
  }
  if (screen_) screen_->Share = nullptr;
  const int frames = wanted();
  const int rays = plain ? 0 : blurredRays();
  const bool behind = !plain && looksBehind();
  active_ = !plain && (frames > 0 || rays > 0 || behind);
  for (const DrawnObject& object : content_->objects) object.pass->SetSeparateSpecular(rays > 0);
  if (!active_) {
    endFrame();
    return;
  }
  if (!screen_) screen_ = makePass();
  Key now = key();
  // A picture without averaging is drawn whenever it is requested, as without the pass.
  if (!(now == shown_) || (frames == 0 && rays == 0)) {
    screen_->Restart();
    shown_ = std::move(now);
  }
  screen_->Limit = std::max(frames, 1);
  show(rays, behind);
}

vtkPicturePass* PictureFrames::refinedPass(const RefineSettings& settings) {
  if (firstGuess() == 0) return nullptr;
  for (const DrawnObject& object : content_->objects) object.pass->SetSeparateSpecular(false);
  if (!linear_) linear_ = makePass();
  linear_->Behind = looksBehind();
  linear_->BlurredRays = 0;
  linear_->Sky = content_->sky;
  beginRefinement(linear_, settings);
  tried_ = refining_ = false;  // the window's refinement starts again
  linear_->Advance = [this] { return linear_->GetFrames() == 0 || advance(linear_, false); };
  return linear_;
}

vtkPicturePass* PictureFrames::linearPass(int frames) {
  const int rays = blurredRays();
  for (const DrawnObject& object : content_->objects) object.pass->SetSeparateSpecular(rays > 0);
  const bool behind = looksBehind();
  if (rays == 0 && (frames <= 1 || !averages()) && !behind) return nullptr;
  if (!linear_) linear_ = makePass();
  linear_->Restart();
  linear_->Share = nullptr;
  linear_->Advance = nullptr;
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
  endFrame();
  active_ = refining_ = tried_ = false;
  for (const auto& pass : {screen_, linear_}) {
    if (pass) pass->ReleaseGraphicsResources(window_);
  }
}

}  // namespace boxprobe
