#include "filters/vtk/probes/probe_entries.h"

#include <algorithm>

namespace boxprobe {

namespace {

// Up to so many probes all are made at once, so that the camera may turn without waiting for them; of more, those that
// something in the frame is lit by.
constexpr std::size_t kAllAtOnce = 8;

}  // namespace

std::optional<std::size_t> ProbeEntries::find(const std::string& name) const {
  const auto found = byName_.find(name);
  return found == byName_.end() ? std::nullopt : std::optional(found->second);
}

bool ProbeEntries::matched() const {
  const std::vector<Probe>& probes = scene_->probes;
  return std::equal(entries_.begin(), entries_.end(), probes.begin(), probes.end(),
                    [](const ProbeEntry& entry, const Probe& probe) { return entry.name == probe.name; });
}

std::optional<ProbeEntries::Origins> ProbeEntries::match() {
  places_ = ProbeIndex(scene_->probes);
  if (matched()) return std::nullopt;
  Origins origins;
  std::vector<ProbeEntry> next;
  for (const Probe& probe : scene_->probes) {
    origins.push_back(find(probe.name));
    next.push_back(origins.back() ? entries_[*origins.back()] : ProbeEntry{});
    next.back().name = probe.name;
  }
  entries_ = std::move(next);
  byName_.clear();
  for (std::size_t i = 0; i < entries_.size(); ++i) byName_.emplace(entries_[i].name, i);
  return origins;
}

void ProbeEntries::setUse(std::vector<ObjectUse> objects) {
  objects_ = std::move(objects);
  for (ProbeEntry& entry : entries_) entry.used = false;
  for (const ObjectUse& object : objects_) {
    for (const std::size_t probe : object.probes) entries_[probe].used |= object.lit;
  }
  findSeen();
}

bool ProbeEntries::setSeen(std::optional<std::vector<std::size_t>> objects) {
  seenObjects_ = std::move(objects);
  return findSeen();
}

bool ProbeEntries::findSeen() {
  const auto used = std::count_if(entries_.begin(), entries_.end(), [](const ProbeEntry& entry) { return entry.used; });
  const bool all = !seenObjects_ || static_cast<std::size_t>(used) <= kAllAtOnce;
  std::vector<bool> seen(entries_.size(), all);
  for (std::size_t i = 0; !all && i < seenObjects_->size(); ++i) {
    const std::size_t object = (*seenObjects_)[i];
    if (object >= objects_.size() || !objects_[object].lit) continue;  // not drawn with any probe yet
    for (const std::size_t probe : objects_[object].probes) seen[probe] = true;
  }
  bool changed = false;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    changed |= entries_[i].seen != seen[i];
    entries_[i].seen = seen[i];
  }
  return changed;
}

bool ProbeEntries::anyLit() const {
  return std::any_of(objects_.begin(), objects_.end(), [](const ObjectUse& object) { return object.lit; });
}

}  // namespace boxprobe
