#include "filters/vtk/probes/probe_programs.h"

#include <algorithm>

#include "filters/vtk/probes/probe_assignment.h"

namespace boxprobe {

void ProbePrograms::assign(bool newProgramsAllowed) {
  const auto drawn = shown_->all();
  toPrepare_.clear();
  for (std::size_t i = 0; i < content_->objects.size(); ++i) {
    DrawnObject& object = content_->objects[i];
    const auto meeting = entries_->places().meeting(worldBounds(object));
    auto binding = assignProbes(object, content_->scene, drawn, meeting, plan_->enabled(), plan_->interactive());
    const std::string key = binding->variantKey();
    const ProbeBinding* current = object.mapper->GetBinding();
    // A box dragged over further objects would need programs that are not compiled yet; that waits for the drag's end.
    if (!newProgramsAllowed && current != nullptr && current->variantKey() != key && variantsUsed_.count(key) == 0)
      continue;
    variantsUsed_.insert(key);
    object.mapper->SetBinding(std::move(binding));
    if (plan_->interactive()) continue;
    const auto general = assignProbes(object, content_->scene, drawn, meeting, plan_->enabled(), true);
    if (editable_ && general->variantKey() != key) prepare(i, general);
    if (!standInsAllowed_) continue;
    prepare(i, object.mapper->GetBinding()->standIn());
    if (editable_) prepare(i, general->standIn());
  }
  recordUse();
  updateStandIns();
}

// By what objects are drawn with, not by what meets them.
void ProbePrograms::recordUse() {
  state_->resources.shadowLightsInUse.clear();
  std::vector<ObjectUse> uses;
  for (const DrawnObject& object : content_->objects) {
    ObjectUse use;
    use.lit = !object.unlit && object.settings.visible;
    if (const ProbeBinding* binding = object.mapper->GetBinding()) {
      state_->resources.shadowLightsInUse.insert(binding->shadowLights.begin(), binding->shadowLights.end());
      for (const auto& probe : binding->probes) {
        // During a drag an object may still be drawn with one that is no longer in the list.
        if (shown_->has(*probe)) use.probes.push_back(static_cast<std::size_t>(probe->index));
      }
    }
    uses.push_back(std::move(use));
  }
  entries_->setUse(std::move(uses));
}

void ProbePrograms::prepare(std::size_t object, std::shared_ptr<const ProbeBinding> binding) {
  if (binding) toPrepare_.emplace_back(object, std::move(binding));
}

void ProbePrograms::allowStandIns(bool allowed) {
  if (standInsAllowed_ == allowed) return;
  standInsAllowed_ = allowed;
  assign();
}

bool ProbePrograms::setMoving(bool moving) {
  moving_ = moving && standInsAllowed_;
  updateStandIns();
  const auto& objects = content_->objects;
  const bool any = std::any_of(objects.begin(), objects.end(), [](const DrawnObject& object) {
    return object.settings.visible && object.mapper->GetDrawnBinding() != object.mapper->GetBinding();
  });
  moving_ = moving_ && any;
  return any;
}

void ProbePrograms::updateStandIns() {
  const bool show = moving_ && !plan_->capturesLast();
  for (DrawnObject& object : content_->objects) {
    const auto cheap = show && object.mapper->GetBinding() ? object.mapper->GetBinding()->standIn() : nullptr;
    object.mapper->SetStandIn(cheap && prepared_.count(cheap->variantKey() + object.materialName) > 0);
  }
}

// Draws one object into a few pixels with the program a drag will need, so that it is compiled by then.
void ProbePrograms::prepareOne() {
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
