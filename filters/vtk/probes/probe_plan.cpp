#include "filters/vtk/probes/probe_plan.h"

#include <algorithm>

#include "filters/vtk/probes/probe_memory.h"

namespace boxprobe {

namespace {

constexpr int kSkyFaceSize = 64;  // a gradient has no detail
constexpr int kLargestSkyFaceSize = 256;

int skyFaceSize(int imageColumns) {
  int size = kSkyFaceSize;
  while (size < kLargestSkyFaceSize && 4 * size < imageColumns) size *= 2;
  return size;
}

}  // namespace

void ProbePlan::wantSky(std::string key, int imageColumns) {
  skyWanted_ = std::move(key);
  skyImageColumns_ = imageColumns;
}

bool ProbePlan::stale(std::size_t index) const {
  const ProbeEntry& entry = (*entries_)[index];
  if (entry.wanted.empty()) return false;
  if (!targets_.empty()) {
    if (targets_.count(entry.name) == 0 || !entries_->baked(index)) return false;
    return entry.shown != entry.wanted && !sources_->folder.has(entry.wanted);
  }
  if (!entry.needed()) return false;
  if (entries_->probe(index).mode == ProbeMode::Realtime) return entry.shown != entry.wanted || entry.passes > 0;
  return entry.shown != entry.wanted && !(interactive_ && entry.shown == entry.wanted + kDuringDrag);
}

void ProbePlan::make() {
  jobs_.clear();
  memoryChecked_ = false;
  memoryError_.clear();
  if (!enabled_) return;
  for (std::size_t i = 0; i < entries_->size(); ++i) {
    if (!stale(i)) continue;
    const Probe& p = entries_->probe(i);
    const std::string& wanted = (*entries_)[i].wanted;
    if (p.mode == ProbeMode::Realtime) {
      jobs_.push_back({JobKind::Realtime, p.name, 1, {}, p.faceSize});
    } else if (p.mode == ProbeMode::Custom) {
      jobs_.push_back({JobKind::Picture, p.name, 1, wanted, sources_->pictures.picture(p.name)->faceSize()});
    } else if (interactive_) {
      jobs_.push_back({JobKind::Drag, p.name, 1, wanted + kDuringDrag, p.faceSize});
    }
  }
  if (!interactive_) planBounces();
  planSky();
}

bool ProbePlan::bakesAny() const {
  for (std::size_t i = 0; i < entries_->size(); ++i) {
    if (targets_.count((*entries_)[i].name) != 0 && entries_->baked(i)) return true;
  }
  return false;
}

void ProbePlan::planSky() {
  if (skyWanted_.empty() || !skyStale()) return;
  // With baked probes goes the sky's file, which may be gone or damaged by itself.
  const bool asked =
      targets_.empty() ? entries_->anyLit() : !jobs_.empty() || (bakesAny() && !sources_->folder.has(skyWanted_));
  if (!asked) return;
  const int faceSize = skyFaceSize(skyImageColumns_);
  JobKind kind = JobKind::SkyMap;
  if (sources_->folder.has(skyWanted_)) {
    kind = JobKind::File;
  } else if (targets_.empty() && !sources_->skyLevels.empty() &&
             holdsSkyLevels(sources_->skyLevels, skyWanted_, faceSize)) {
    kind = JobKind::Levels;  // not for a bake, whose files tell what captured them
  }
  jobs_.insert(jobs_.begin(), {kind, {}, 1, skyWanted_, faceSize});
}

void ProbePlan::planBounces() {
  const BounceKeys& bounces = keys_->bounces();
  std::vector<std::pair<int, std::size_t>> missing;
  std::set<std::string> onDisk;
  const auto have = [&](const std::string& key) {
    if (key.empty() || sources_->cached(key)) return true;
    if (!sources_->folder.has(key)) return false;
    onDisk.insert(key);
    return true;
  };
  for (std::size_t i = 0; i < entries_->size(); ++i) {
    if (stale(i) && entries_->baked(i)) bounces.collect(i, entries_->probe(i).bounces, have, missing);
  }
  for (std::size_t i = 0; i < entries_->size(); ++i) {
    // Of the final maps, or of a bounce that others were sent ahead to make.
    const Probe& p = entries_->probe(i);
    for (int bounce = p.bounces; bounce >= 1 && !bounces.input(i).view.empty(); --bounce) {
      const std::string& key = bounces.key(i, bounce);
      if (onDisk.erase(key) != 0) jobs_.push_back({JobKind::File, p.name, bounce, key, p.faceSize});
    }
  }
  std::stable_sort(missing.begin(), missing.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [bounce, index] : missing) planBounce(index, bounce);
}

void ProbePlan::planBounce(std::size_t index, int bounce) {
  const Probe& p = entries_->probe(index);
  const std::string& key = keys_->bounces().key(index, bounce);
  ProbeJob job{JobKind::Bounce, p.name, bounce, key, p.faceSize};
  if (keys_->bounces().input(index).imported) {
    job.kind = JobKind::Picture;
    job.faceSize = sources_->pictures.picture(p.name)->faceSize();
  }
  if (std::find(jobs_.begin(), jobs_.end(), job) == jobs_.end()) jobs_.push_back(std::move(job));
}

bool ProbePlan::keepsCurrent() const {
  if (!current_ || !enabled_) return false;
  const auto index = entries_->find(current_->name);
  if (current_->kind == JobKind::Realtime) {
    return index && entries_->probe(*index).mode == ProbeMode::Realtime &&
           entries_->probe(*index).faceSize == current_->faceSize;
  }
  if (current_->kind == JobKind::Drag) return interactive_ && index && entries_->baked(*index);
  return std::find(jobs_.begin(), jobs_.end(), *current_) != jobs_.end();
}

bool ProbePlan::capturesLast() const {
  const auto lasts = [](const ProbeJob& job) {
    return job.kind != JobKind::Drag && job.kind != JobKind::File && job.kind != JobKind::Levels;
  };
  return std::any_of(jobs_.begin(), jobs_.end(), lasts) || (current_ && lasts(*current_));
}

bool ProbePlan::checkMemory(std::size_t limitBytes) {
  memoryChecked_ = true;
  const auto asked = [&](std::size_t i) {
    const ProbeEntry& entry = (*entries_)[i];
    return !entry.wanted.empty() && (targets_.empty() ? entry.needed() : targets_.count(entry.name) != 0);
  };
  MemoryNeed need;
  for (std::size_t i = 0; i < entries_->size(); ++i) {
    if (asked(i)) need.add(entries_->probe(i), sources_->pictures);
  }
  memoryError_ = need.bytes() <= limitBytes ? std::string() : need.error(limitBytes);
  return memoryError_.empty();
}

BakeState ProbePlan::state(const std::string& probeName) const {
  const auto index = entries_->find(probeName);
  if (!index) return BakeState::NotUsed;
  const ProbeEntry& entry = (*entries_)[*index];
  if (current_ && current_->name == probeName) return BakeState::Capturing;
  if (!entry.wanted.empty() && entry.shown == entry.wanted) {
    return entry.fromFile ? BakeState::FromFile : BakeState::UpToDate;
  }
  if (!entry.needed() && targets_.count(probeName) == 0) return BakeState::NotUsed;
  if (sources_->folder.has(entry.wanted)) return BakeState::FromFile;
  return BakeState::Stale;
}

std::optional<BakeRecord> ProbePlan::record(const std::string& probeName) const {
  if (probeName.empty()) {
    if (skyShown_.empty() || skyStale()) return std::nullopt;
    return BakeRecord{skyShown_, skyShown_, {}, {}};
  }
  const auto index = entries_->find(probeName);
  if (!index || !entries_->baked(*index) || (*entries_)[*index].shown != (*entries_)[*index].wanted) {
    return std::nullopt;
  }
  return keys_->bounces().record(*index);
}

}  // namespace boxprobe
