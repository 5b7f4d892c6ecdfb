#include "filters/vtk/capture/bake_runner.h"

#include <vtkOpenGLRenderWindow.h>

#include "filters/math/cube/cube_filter.h"
#include "filters/vtk/draw/pass_scope.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/maps/cube_transfer.h"

namespace boxprobe {

namespace {

constexpr int kFaces = 6;

}  // namespace

CaptureSettings captureSettings(const Probe& probe) {
  CaptureSettings settings;
  settings.originWorld = probe.origin;
  settings.rotationDegrees = probe.rotationDegrees;
  settings.nearDistance = probe.nearDistance;
  settings.farDistance = probe.farDistance;
  settings.clear = probe.clear;
  settings.samplesPerTexelSide = samplesPerSide(probe.samplesPerPixel);
  return settings;
}

PrefilterSettings prefilterSettings(const Probe& probe) {
  PrefilterSettings settings;
  if (probe.filter == FilterKind::Gaussian) settings.filter = FilterLobe::Kind::Gaussian;
  settings.samples = probe.filterSamples;
  return settings;
}

BakeRunner::BakeRunner(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, CubeCapture* capture,
                       Times* times)
    : window_(window),
      state_(std::move(state)),
      capture_(capture),
      times_(times),
      prefilter_(window, &state_->counts.counters),
      later_(std::make_shared<LevelFilter>(window, &prefilter_)) {
  // Counts levels of captured maps only.
  state_->resources.filterLevels = [later = std::weak_ptr<LevelFilter>(later_), counters = &state_->counts.counters](
                                       const CubeTexture& chain, LevelMask levels, const PrefilterSettings& settings) {
    const auto counted = counters->levelsFiltered;
    if (const auto filter = later.lock()) filter->make(chain, levels, settings);
    counters->levelsFiltered = counted;
  };
}

// Six faces; the source's mip chain together with the copy of level 0; level 1; further levels; the diffuse light,
// which takes hardly any time, together with the last of them.
int BakeRunner::units(int faceSize, bool fewSteps) {
  const int levels = prefilterLevels(faceSize);
  return kFaces + 1 + (fewSteps && levels > 2 ? 2 : levels - 1);
}

void BakeRunner::start(BakeItem item) {
  abort();
  item_ = std::make_unique<BakeItem>(std::move(item));
}

void BakeRunner::abort() {
  item_.reset();
  maps_.reset();
  face_ = unit_ = level_ = 0;
  prefilter_.forgetSource();
}

void BakeRunner::step() {
  if (!pending()) return;
  BounceCost& cost = times_->bounces[static_cast<std::size_t>(item_->bounce - 1)];
  const double before = processCpuSeconds();
  const std::uint64_t captured = state_->counts.counters.facesCaptured;
  const bool facesDone = makeFaces();
  const bool done = facesDone && filter();
  if (!item_->sky) {
    cost.cpuSeconds += processCpuSeconds() - before;
    cost.faces += state_->counts.counters.facesCaptured - captured;
  }
  ++unit_;
  if (!done) return;
  const auto publish = std::move(item_->publish);
  const auto maps = std::move(maps_);
  abort();
  publish(maps);
}

// True when all six are done and the step can do something else. Copied faces take hardly any time and do not end a
// step.
bool BakeRunner::makeFaces() {
  if (face_ == kFaces) return true;
  const CpuTimer timer(times_->captureCpuSeconds);
  if (face_ == 0) {
    maps_ = std::make_shared<ProbeMaps>();
    maps_->forTheTimeBeing = item_->coarse;
    maps_->capturedAt = item_->settings.originWorld;
    maps_->capturedRotation = item_->settings.rotationDegrees;
    source_.allocate(item_->faceSize, fullLevels(item_->faceSize), GL_RGBA16F);
    if (item_->picture) {
      uploadLevel0(*item_->picture, source_);
      face_ = kFaces;
      return false;
    }
    if (!item_->sky) maps_->distance.allocate(item_->faceSize, 1, GL_R32F);
  }
  while (face_ < kFaces) {
    const int face = face_++;
    const FaceSource source = item_->face(face);
    if (!source.same) {
      captureFace(source, face);
      return false;
    }
    copyFace(*source.same, face);
    ++state_->counts.counters.facesReused;
  }
  return true;
}

void BakeRunner::captureFace(const FaceSource& source, int face) {
  // Restored even if the driver refuses the capture: the window continues to draw.
  struct Drawing {
    const BakeItem& item;
    explicit Drawing(const BakeItem& i) : item(i) {
      if (item.drawing) item.drawing(true);
    }
    ~Drawing() {
      if (item.drawing) item.drawing(false);
    }
  };
  {
    const Drawing drawing(*item_);
    const PassScope scope(*state_, [this](PassSettings& pass) {
      pass.capture = !item_->sky;
      pass.sight = item_->sight ? item_->sight() : nullptr;
      pass.firstBounce = item_->reflectNothing;
      pass.firstBouncePrograms = item_->reflectNothing && item_->firstBouncePrograms;
      pass.movingShadowsOn = false;
      pass.sunDisc = false;
    });
    capture_->captureFace(item_->settings, face, source.props, source.lights, source_,
                          item_->sky ? nullptr : &maps_->distance);
  }
  Counters& counters = state_->counts.counters;
  ++(item_->sky ? counters.skyFacesCaptured : item_->coarse ? counters.coarseFaces : counters.facesCaptured);
  if (item_->sky || item_->coarse) return;
  counters.objectsCaptured += source.objects;
  counters.objectsCulled += source.culled;
}

void BakeRunner::copyFace(const ProbeMaps& from, int face) {
  const PassState saved(window_);
  const auto copy = [&](const CubeTexture& a, const CubeTexture& b) {
    to_.bind(window_, b, face, 0);
    from_.bind(window_, a, face, 0);
    to_.bindDraw(window_);
    const int size = a.faceSize();
    glBlitFramebuffer(0, 0, size, size, 0, 0, size, size, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  };
  copy(from.radiance, source_);
  if (!item_->sky) copy(from.distance, maps_->distance);
}

// Skips levels that no material samples, unless level 0 is blurred: the capture, from which levels are filtered later,
// would be lost.
void BakeRunner::beginFilter(int levels) {
  maps_->radiance.allocate(item_->faceSize, levels, GL_RGBA16F);
  prefilter_.begin(source_, maps_->radiance, item_->prefilter);
  const bool keepsCapture = lobeOfLevel(item_->prefilter, 0, levels - 1).width <= 0.0f;
  if (!item_->levels || !keepsCapture) return;
  maps_->filtered = item_->levels(levels) | 1u;
  if (maps_->missing(kAllLevels) == 0) return;
  maps_->filterLevels = [later = std::weak_ptr<LevelFilter>(later_), counters = &state_->counts.counters,
                         settings = item_->prefilter](const ProbeMaps& maps, LevelMask missing) {
    const auto filter = later.lock();
    if (!filter) return false;
    filter->make(maps.radiance, missing, settings);
    for (LevelMask rest = missing; rest != 0; rest &= rest - 1) ++counters->levelsMadeLater;
    return true;
  };
}

bool BakeRunner::filter() {
  const CpuTimer timer(times_->prefilterCpuSeconds);
  const int levels = prefilterLevels(item_->faceSize);
  if (level_ == 0) {
    beginFilter(levels);
    level_ = 1;
    return false;
  }
  bool more = true;
  while (more && level_ < levels) {
    const bool skips = skipped(level_);
    if (skips) {
      prefilter_.copyLevel(source_, maps_->radiance, level_);
      ++state_->counts.counters.levelsSkipped;
    } else {
      prefilter_.filterLevel(source_, maps_->radiance, level_, item_->prefilter);
    }
    ++level_;
    more = item_->fewSteps ? level_ > 2 : skips;
  }
  if (level_ < levels) return false;
  maps_->irradiance = Prefilter::irradiance(source_, rotationMatrix(item_->settings.rotationDegrees));
  return true;
}

void BakeRunner::release() {
  abort();
  prefilter_.release();
  later_->release();
  source_.release();
  from_.release();
  to_.release();
}

LevelFilter::LevelFilter(vtkOpenGLRenderWindow* window, Prefilter* prefilter)
    : window_(window), prefilter_(prefilter) {}

void LevelFilter::make(const CubeTexture& chain, LevelMask levels, const PrefilterSettings& settings) {
  window_->MakeCurrent();
  source_.allocate(chain.faceSize(), fullLevels(chain.faceSize()), GL_RGBA16F);
  prefilter_->copyLevel(chain, source_, 0);
  prefilter_->makeSourceLevels(source_);
  for (int level = 1; level < chain.levels(); ++level) {
    if ((levels >> level & 1u) == 0) continue;
    prefilter_->filterLevel(source_, chain, level, settings);
  }
  prefilter_->forgetSource();
  source_.release();
}

void LevelFilter::release() {
  source_.release();
}

}  // namespace boxprobe
