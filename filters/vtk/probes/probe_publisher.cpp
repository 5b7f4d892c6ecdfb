#include "filters/vtk/probes/probe_publisher.h"

namespace boxprobe {

void ProbePublisher::publish(MadeMaps made) {
  if (made.job.name.empty()) return publishSky(std::move(made));
  if (made.job.kind == JobKind::Drag) return publishDrag(std::move(made));
  if (made.job.kind == JobKind::Realtime) return publishRealtime(std::move(made));
  publishFinal(std::move(made));
}

void ProbePublisher::show(std::size_t index, const std::string& key, std::shared_ptr<const ProbeMaps> maps) {
  const bool turned = shown_->show(index, std::move(maps));
  // Another program, perhaps.
  if (light_->updateOpenings() || turned) programs_->assign();
  ProbeEntry& entry = (*entries_)[index];
  entry.shown = key;
  entry.faces = {};
}

void ProbePublisher::showSky(const std::string& key, std::shared_ptr<const ProbeMaps> maps) {
  state_->resources.sky = std::move(maps);
  plan_->skyShows(key);
  if (light_->updateOpenings()) programs_->assign();
}

void ProbePublisher::showCached() {
  for (std::size_t i = 0; i < entries_->size(); ++i) {
    ProbeEntry& entry = (*entries_)[i];
    if (entry.wanted == entry.shown || entry.wanted.empty()) continue;
    if (auto maps = cache_->find(entry.wanted)) {
      show(i, entry.wanted, std::move(maps));
      entry.fromFile = false;
    }
  }
  if (!plan_->skyStale()) return;
  if (auto maps = cache_->find(plan_->skyWanted())) showSky(plan_->skyWanted(), std::move(maps));
}

void ProbePublisher::publishSky(MadeMaps made) {
  showSky(made.job.key, made.maps);
  cache_->add(made.job.key, {}, std::move(made.maps));
}

void ProbePublisher::publishDrag(MadeMaps made) {
  const auto index = entries_->find(made.job.name);
  if (!index) return;
  light_->addTint(*index, *made.maps);
  // Dragged back to where it was: the final maps are there already.
  const ProbeEntry& entry = (*entries_)[*index];
  if (entry.shown != entry.wanted) show(*index, made.job.key, std::move(made.maps));
}

void ProbePublisher::publishRealtime(MadeMaps made) {
  const auto index = entries_->find(made.job.name);
  if (!index) return;
  ProbeEntry& entry = (*entries_)[*index];
  const std::string& key = made.job.key;
  if (key == entry.wanted && entry.shown == key && entry.passes > 0) --entry.passes;
  light_->addTint(*index, *made.maps);
  show(*index, key, std::move(made.maps));
  entry.faces = std::move(made.faces);
  entry.again = entry.fromFile = false;
}

void ProbePublisher::publishFinal(MadeMaps made) {
  const std::string& key = made.job.key;
  const auto index = entries_->find(made.job.name);
  if (index) light_->addTint(*index, *made.maps);
  // Maps of a bounce before the last are shown for the time being, but not in place of final ones.
  const bool last = index && key == (*entries_)[*index].wanted;
  if (index && (last || plan_->stale(*index))) show(*index, key, made.maps);
  if (last) {
    (*entries_)[*index].again = false;
    (*entries_)[*index].fromFile = made.fromFile;
    keys_->remember(*index);
  }
  for (std::size_t i = 0; i < entries_->size(); ++i) {
    const ProbeEntry& entry = (*entries_)[i];
    if (entry.wanted == key && entry.shown != key) show(i, key, made.maps);
  }
  earlier_.push_back(made.maps);
  cache_->add(key, std::move(made.faces), std::move(made.maps));
}

}  // namespace boxprobe
