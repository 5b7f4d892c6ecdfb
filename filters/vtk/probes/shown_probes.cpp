#include "filters/vtk/probes/shown_probes.h"

namespace boxprobe {

// A picture of the user's has no capture origin: it belongs where the probe stands now.
ProbeGeometry ShownProbes::geometry(std::size_t index, const ProbeMaps* maps) const {
  const Probe& probe = scene_->probes[index];
  if (maps == nullptr) return probeGeometry(probe, probe.origin, probe.rotationDegrees);
  const bool imported = probe.mode == ProbeMode::Custom;
  return probeGeometry(probe, imported ? probe.origin : maps->capturedAt, maps->capturedRotation);
}

void ShownProbes::rearrange(const ProbeEntries::Origins& origins) {
  std::vector<ShownProbe> next;
  for (const auto& origin : origins) next.push_back(origin ? probes_[*origin] : ShownProbe{});
  probes_ = std::move(next);
  ++generation_;
}

void ShownProbes::updateShapes() {
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    drawn(i).index = static_cast<int>(i);
    drawn(i).geometry = geometry(i, drawn(i).maps.get());
  }
}

bool ShownProbes::has(const DrawnProbe& probe) const {
  const auto index = static_cast<std::size_t>(probe.index);
  return index < probes_.size() && probes_[index].drawn.get() == &probe;
}

std::vector<std::shared_ptr<DrawnProbe>> ShownProbes::all() const {
  std::vector<std::shared_ptr<DrawnProbe>> all;
  for (const ShownProbe& probe : probes_) all.push_back(probe.drawn);
  return all;
}

bool ShownProbes::show(std::size_t index, std::shared_ptr<const ProbeMaps> maps) {
  DrawnProbe& probe = drawn(index);
  const bool turned = probe.geometry.mapTurned;
  probe.geometry = geometry(index, maps.get());
  probe.maps = std::move(maps);
  ++generation_;
  return probe.geometry.mapTurned != turned;
}

void ShownProbes::see(const std::function<std::shared_ptr<const ProbeMaps>(std::size_t)>& maps) {
  windowSees_.clear();
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    DrawnProbe& probe = drawn(i);
    windowSees_.push_back({probe.maps, probe.geometry});
    probe.maps = maps(i);
    probe.geometry = geometry(i, probe.maps.get());
  }
}

void ShownProbes::seeAgain() {
  for (std::size_t i = 0; i < probes_.size() && i < windowSees_.size(); ++i) {
    drawn(i).maps = std::move(windowSees_[i].maps);
    drawn(i).geometry = windowSees_[i].geometry;
  }
  windowSees_.clear();
}

std::function<void(bool)> ShownProbes::withoutSky(std::function<void(bool)> drawing) {
  return [this, drawing = std::move(drawing)](bool begins) {
    if (begins) skyKept_ = state_->resources.sky;
    if (begins) state_->resources.sky = nullptr;
    if (drawing) drawing(begins);
    if (!begins) state_->resources.sky = std::move(skyKept_);
  };
}

void ShownProbes::release() {
  for (ShownProbe& probe : probes_) {
    probe.openSkyOf = {};
    probe.drawn->maps.reset();
    probe.drawn->latticeBefore.reset();
  }
  state_->resources.sky.reset();
}

}  // namespace boxprobe
