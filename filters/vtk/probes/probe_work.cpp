#include "filters/vtk/probes/probe_work.h"

#include <algorithm>

#include "filters/core/base/errors.h"
#include "filters/vtk/maps/cube_transfer.h"

namespace boxprobe {

void ProbeWork::replan() {
  publisher_->showCached();
  plan_->make();
  if (plan_->jobs().empty()) {
    publisher_->dropEarlierBounces();
    unitsDone_ = 0;
    dark_ = false;
  }
  if (!plan_->keepsCurrent()) abort();
  if (programs_->moving()) programs_->updateStandIns();
}

bool ProbeWork::step() {
  if (!runner_->pending() && !plan_->jobs().empty()) {
    const ProbeJob job = plan_->jobs().front();
    if (job.kind == JobKind::File) {
      loadFile(job);
      return true;
    }
    if (job.kind == JobKind::Levels) {
      loadLevels(job);
      return true;
    }
    begin(job);
  }
  if (!runner_->pending()) return false;
  ++unitsDone_;
  runner_->step();
  return true;
}

// Programs for captures without reflections take CPU time to compile, which a few faces do not bring back. For files by
// the probes of the scene, not by those that are left to make: shares of a bake are the same to the bit, and programs
// may round differently.
bool ProbeWork::manyDark() const {
  constexpr int kWorthPrograms = 4;  // probes
  if (!plan_->targets().empty()) {
    int baked = 0;
    for (std::size_t i = 0; i < entries_->size(); ++i) baked += entries_->baked(i) ? 1 : 0;
    return baked >= kWorthPrograms;
  }
  const auto first = [](const ProbeJob& job) { return job.kind == JobKind::Bounce && job.bounce == 1; };
  return std::count_if(plan_->jobs().begin(), plan_->jobs().end(), first) >= kWorthPrograms;
}

void ProbeWork::begin(const ProbeJob& job) {
  dark_ = dark_ || manyDark();
  BakeItem item = items_->item(job, [this](MadeMaps made) { finish(std::move(made)); });
  item.dark = dark_ && job.kind == JobKind::Bounce && !state_->resources.general;
  runner_->start(std::move(item));
  plan_->begin(job);
}

// A file that was damaged since it was looked at is as good as none: its probe is captured.
void ProbeWork::loadFile(const ProbeJob& job) {
  ++unitsDone_;
  MadeMaps made{job, {}, nullptr, true};
  try {
    made.maps = upload(sources_->folder.load(job.key));
  } catch (const InputError& damage) {
    sources_->folder.forget(job.key, damage.what());
    keys_->update(plan_->targets());
    return replan();
  }
  const auto index = entries_->find(job.name);
  for (int face = 0; index && face < 6; ++face) {
    made.faces[static_cast<std::size_t>(face)] = keys_->face(*index, job.bounce, face);
  }
  ++state_->counts.counters.mapsLoaded;
  finish(std::move(made));
}

// The same for levels: the sky is captured then.
void ProbeWork::loadLevels(const ProbeJob& job) {
  ++unitsDone_;
  MadeMaps made{job, {}, nullptr, true};
  try {
    made.maps = upload(loadSkyLevels(sources_->skyLevels));
  } catch (const InputError&) {
    sources_->skyLevels.clear();
    return replan();
  }
  ++state_->counts.counters.mapsLoaded;
  finish(std::move(made));
}

void ProbeWork::finish(MadeMaps made) {
  plan_->end();
  publisher_->publish(std::move(made));
  replan();
}

int ProbeWork::unitsLeft() const {
  if (!pending()) return 0;
  int left = -runner_->unitsDone();
  for (const ProbeJob& job : plan_->jobs()) {
    const bool read = job.kind == JobKind::File || job.kind == JobKind::Levels;
    left += read ? 1 : BakeRunner::units(job.faceSize, job.kind == JobKind::Realtime);
  }
  return std::max(left, 0);
}

void ProbeWork::abort() {
  runner_->abort();
  plan_->end();
}

void ProbeWork::giveUp() {
  abort();
  plan_->giveUp();
  publisher_->dropEarlierBounces();
  unitsDone_ = 0;
}

void ProbeWork::release() {
  runner_->release();
  plan_->end();
  publisher_->dropEarlierBounces();
}

}  // namespace boxprobe
