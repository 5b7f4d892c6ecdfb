#include "filters/vtk/bake_queue.h"

#include <vtkOpenGLRenderWindow.h>

#include <algorithm>

#include "filters/vtk/cpu_time.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

constexpr int kFaces = 6;

int sourceLevels(int faceSize) {
  int levels = 1;
  while (faceSize > 1) {
    faceSize /= 2;
    ++levels;
  }
  return levels;
}

int unitsOf(const BakeItem& item) {
  return kFaces + 1 + (prefilterLevels(item.faceSize) - 1) + 1;
}

}  // namespace

BakeQueue::BakeQueue(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, CubeCapture* capture,
                     Times* times)
    : window_(window),
      state_(std::move(state)),
      capture_(capture),
      times_(times),
      prefilter_(window, &state_->counters) {}

void BakeQueue::start(std::vector<BakeItem> items, std::vector<vtkLight*> lights, bool seeCurrentProbes) {
  abort();
  if (items.empty()) return;
  items_ = std::move(items);
  lights_ = std::move(lights);
  seeCurrentProbes_ = seeCurrentProbes;
  bounce_ = 1;
  unitsTotal_ = 0.0;
  for (const BakeItem& item : items_) {
    lastBounce_ = std::max(lastBounce_, item.bounces);
    unitsTotal_ += item.bounces * unitsOf(item);
  }
}

void BakeQueue::abort() {
  items_.clear();
  finished_.clear();
  maps_.reset();
  bounce_ = lastBounce_ = 0;
  item_ = 0;
  unit_ = 0;
  unitsDone_ = 0.0;
}

double BakeQueue::progress() const {
  return pending() ? unitsDone_ / unitsTotal_ : 1.0;
}

void BakeQueue::step() {
  if (!pending()) return;
  while (item_ < items_.size() && items_[item_].bounces < bounce_) ++item_;
  if (item_ == items_.size()) {
    endBounce();
    return;
  }
  if (advanceItem()) {
    // The sky sees no probe, and the first bounce is lit by it: no reason to wait for the others.
    if (items_[item_].sky) {
      items_[item_].publish(std::move(maps_));
    } else {
      finished_.push_back({item_, std::move(maps_)});
    }
    ++item_;
    unit_ = 0;
  } else {
    ++unit_;
  }
  unitsDone_ += 1.0;
}

// One unit of the current item; true when it was the last one.
bool BakeQueue::advanceItem() {
  const BakeItem& item = items_[item_];
  const int levels = prefilterLevels(item.faceSize);
  if (unit_ < kFaces) {
    const CpuTimer timer(times_->captureCpuSeconds);
    if (unit_ == 0) {
      maps_ = std::make_shared<ProbeMaps>();
      maps_->capturedAt = item.settings.originWorld;
      source_.allocate(item.faceSize, sourceLevels(item.faceSize), GL_RGBA16F);
      if (!item.sky) maps_->distance.allocate(item.faceSize, 1, GL_R32F);
    }
    state_->firstBounce = bounce_ == 1 && !seeCurrentProbes_;
    capture_->captureFace(item.settings, unit_, item.props, lights_, source_, item.sky ? nullptr : &maps_->distance);
    state_->firstBounce = false;
    ++(item.sky ? state_->counters.skyFacesCaptured : state_->counters.facesCaptured);
    return false;
  }
  const CpuTimer timer(times_->prefilterCpuSeconds);
  const int level = unit_ - kFaces;
  if (level == 0) {
    maps_->radiance.allocate(item.faceSize, levels, GL_RGBA16F);
    prefilter_.begin(source_, maps_->radiance);
    return false;
  }
  if (level < levels) {
    prefilter_.filterLevel(source_, maps_->radiance, level);
    return false;
  }
  maps_->irradiance = Prefilter::irradiance(source_);
  return true;
}

// Maps are shown together, so that every capture of a bounce sees the bounce before it, whatever the order of the
// probes.
void BakeQueue::endBounce() {
  for (Pending& done : finished_) items_[done.item].publish(std::move(done.maps));
  finished_.clear();
  item_ = 0;
  if (++bounce_ > lastBounce_) abort();
}

void BakeQueue::release() {
  abort();
  prefilter_.release();
  source_.release();
}

}  // namespace boxprobe
