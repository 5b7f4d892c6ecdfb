// The probe set's programs: which probes each object is drawn with, what stands in for them while something moves, and
// which programs are compiled before they are needed. See probe_set.h.
#include <algorithm>

#include "filters/vtk/probes/probe_assignment.h"
#include "filters/vtk/probes/probe_set.h"

namespace boxprobe {

void ProbeSet::assignToObjects() {
  assign(!interactive_);
}

void ProbeSet::assign(bool newProgramsAllowed) {
  std::vector<std::shared_ptr<DrawnProbe>> drawn;
  for (const Entry& entry : entries_) drawn.push_back(entry.drawn);
  toPrepare_.clear();
  for (std::size_t i = 0; i < content_->objects.size(); ++i) {
    DrawnObject& object = content_->objects[i];
    const auto meeting = index_.meeting(worldBounds(object));
    auto binding = assignProbes(object, content_->scene, drawn, meeting, enabled_, interactive_);
    const std::string key = binding->variantKey();
    const ProbeBinding* current = object.mapper->GetBinding();
    // A box dragged over further objects would need programs that are not compiled yet; that waits for the drag's end.
    if (!newProgramsAllowed && current != nullptr && current->variantKey() != key && variantsUsed_.count(key) == 0)
      continue;
    variantsUsed_.insert(key);
    object.mapper->SetBinding(std::move(binding));
    if (interactive_) continue;
    const auto general = assignProbes(object, content_->scene, drawn, meeting, enabled_, true);
    if (editable_ && general->variantKey() != key) prepare(i, general);
    if (!standInsAllowed_) continue;
    prepare(i, object.mapper->GetBinding()->standIn());
    if (editable_) prepare(i, general->standIn());
  }
  state_->resources.shadowLightsInUse.clear();
  for (const DrawnObject& object : content_->objects) {
    if (const ProbeBinding* binding = object.mapper->GetBinding())
      state_->resources.shadowLightsInUse.insert(binding->shadowLights.begin(), binding->shadowLights.end());
  }
  findUsed();
  updateStandIns();
}

void ProbeSet::prepare(std::size_t object, std::shared_ptr<const ProbeBinding> binding) {
  if (binding) toPrepare_.emplace_back(object, std::move(binding));
}

void ProbeSet::allowStandIns(bool allowed) {
  if (standInsAllowed_ == allowed) return;
  standInsAllowed_ = allowed;
  assignToObjects();
}

bool ProbeSet::setMoving(bool moving) {
  moving_ = moving && standInsAllowed_;
  updateStandIns();
  const auto& objects = content_->objects;
  const bool any = std::any_of(objects.begin(), objects.end(), [](const DrawnObject& object) {
    return object.settings.visible && object.mapper->GetDrawnBinding() != object.mapper->GetBinding();
  });
  moving_ = moving_ && any;
  return any;
}

// Is anything under way that will be kept? What a drag captures is replaced at its end.
bool ProbeSet::capturesLast() const {
  const auto lasts = [](const Job& job) { return job.kind != JobKind::Drag && job.kind != JobKind::File; };
  return std::any_of(jobs_.begin(), jobs_.end(), lasts) || (runner_.pending() && current_ && lasts(*current_));
}

void ProbeSet::updateStandIns() {
  const bool show = moving_ && !capturesLast();
  for (DrawnObject& object : content_->objects) {
    const auto cheap = show && object.mapper->GetBinding() ? object.mapper->GetBinding()->standIn() : nullptr;
    object.mapper->SetStandIn(cheap && prepared_.count(cheap->variantKey() + object.materialName) > 0);
  }
}

// Draws one object into a few pixels with the program a drag will need, so that it is compiled by then.
void ProbeSet::prepareOne() {
  auto [index, general] = std::move(toPrepare_.back());
  toPrepare_.pop_back();
  DrawnObject& object = content_->objects[index];
  if (!object.settings.visible || !prepared_.insert(general->variantKey() + object.materialName).second) return;
  const auto binding = object.mapper->GetSharedBinding();
  variantsUsed_.insert(general->variantKey());
  const bool apart = object.mapper->GetSeparateSpecular();
  object.mapper->SetSeparateSpecular(apart && general->blurredSamples() > 0);
  object.mapper->SetBinding(std::move(general));
  CaptureSettings settings;
  settings.originWorld = worldBounds(object).center();
  capture_->drawOnce(settings, {object.actor}, content_->lightPointers());
  object.mapper->SetBinding(binding);
  object.mapper->SetSeparateSpecular(apart);
}

}  // namespace boxprobe
