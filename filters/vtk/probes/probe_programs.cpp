#include "filters/vtk/probes/probe_programs.h"

#include <vtkProperty.h>

#include <algorithm>
#include <map>
#include <new>

#include "filters/vtk/draw/constant_plans.h"
#include "filters/vtk/draw/surface_facts.h"
#include "filters/vtk/probes/probe_baker.h"
#include "filters/vtk/probes/probe_binder.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

namespace {

// What an object's program is, facts and constants apart.
std::string generalProgram(const DrawnObject& object) {
  const ProbeBinding* binding = object.pass->GetBinding();
  return object.surface->programKey() + (object.actor->GetProperty()->GetCoatStrength() > 0.0 ? "c" : "") +
         (object.pass->GetMirror() ? "m" : "") + (binding != nullptr ? binding->variantKey() : "");
}

SurfaceFacts foldedFacts(const DrawnObject& object) {
  return object.pass->GetFoldableFacts() & surfaceFacts(*object.surface, object.actor->GetProperty());
}

}  // namespace

bool ProbePrograms::known(const ProbeBinding& now, const ProbeBinding& next) const {
  const std::string key = next.variantKey();
  return now.variantKey() == key || variantsUsed_.count(key) != 0;
}

void ProbePrograms::assigned() {
  toPrepare_.clear();
  unfoldConstants();
  for (std::size_t i = 0; i < with_.content->objects.size(); ++i) {
    const DrawnObject& object = with_.content->objects[i];
    const std::string key = object.pass->GetBinding()->variantKey();
    variantsUsed_.insert(key);
    if (with_.plan->interactive()) continue;
    const auto general = with_.binder->bindingOf(object, true);
    if (editable_ && general->variantKey() != key) prepare(i, general);
    if (!standInsAllowed_) continue;
    prepare(i, object.pass->GetBinding()->standIn());
    if (editable_) prepare(i, general->standIn());
  }
  updateStandIns();
  foldFacts();
}

void ProbePrograms::replanned() {
  if (moving_) updateStandIns();
}

// Not while a handle is held: other facts may mean other programs.
void ProbePrograms::foldFacts() {
  if (with_.plan->interactive()) return;
  std::vector<FactUse> uses;
  for (const DrawnObject& object : with_.content->objects) {
    uses.push_back({generalProgram(object), surfaceFacts(*object.surface, object.actor->GetProperty())});
  }
  const std::vector<SurfaceFacts> facts = foldableFacts(uses);
  for (std::size_t i = 0; i < facts.size(); ++i) with_.content->objects[i].pass->SetFoldableFacts(facts[i]);
}

void ProbePrograms::unfoldConstants() {
  toFold_.clear();
  for (const DrawnObject& object : with_.content->objects) object.pass->SetConstants(nullptr);
}

void ProbePrograms::foldConstants() {
  toFold_.clear();
  const auto& probes = with_.content->scene.probes;
  // A probe captured over and over never rests.
  const bool never =
      std::any_of(probes.begin(), probes.end(), [](const Probe& probe) { return probe.mode == ProbeMode::Realtime; });
  if (with_.plan->interactive() || moving_ || never) return;
  std::vector<std::size_t> objects;
  std::vector<ConstantUse> uses;
  std::set<std::string> general, folded;
  for (std::size_t i = 0; i < with_.content->objects.size(); ++i) {
    const DrawnObject& object = with_.content->objects[i];
    if (!object.settings.visible || object.pass->GetDrawnBinding() == nullptr) continue;
    const std::string program = generalProgram(object);
    general.insert(program);
    objects.push_back(i);
    uses.push_back({program + "/" + std::to_string(foldedFacts(object)), object.pass->GetRestingValues(object.actor)});
    folded.insert(uses.back().program);
  }
  const std::size_t most = general.size() + general.size() / 2;
  const auto plans = foldableConstants(uses, most > folded.size() ? most - folded.size() : 0);
  std::map<std::pair<std::string, const RestingValues*>, Fold> folds;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (!plans[k]) continue;
    Fold& fold = folds[{uses[k].program, plans[k].get()}];
    fold.objects.push_back(objects[k]);
    if (fold.plan) continue;
    const std::string variant = with_.content->objects[objects[k]].pass->GetDrawnBinding()->variantKey();
    fold.plan = std::make_shared<const ConstantsPlan>(ConstantsPlan{variant, *plans[k]});
  }
  for (auto& fold : folds) toFold_.push_back(std::move(fold.second));
}

// Where the driver or the memory refuses the program, the one that is on show stays.
void ProbePrograms::foldNext() {
  const Fold fold = std::move(toFold_.back());
  toFold_.pop_back();
  const DrawnObject& first = with_.content->objects[fold.objects.front()];
  first.pass->SetConstants(fold.plan);
  CaptureSettings settings;
  settings.originWorld = worldBounds(first).center();
  bool refused = false;
  try {
    with_.baker->capture()->drawOnce(settings, {first.actor}, with_.content->lightPointers());
    refused = first.pass->GetConstantsRefused();
  } catch (const std::bad_alloc&) {
    refused = true;
  }
  if (refused) {
    first.pass->SetConstants(nullptr);
    return;
  }
  for (const std::size_t object : fold.objects) with_.content->objects[object].pass->SetConstants(fold.plan);
  with_.state->counts.counters.constantsFolded += fold.objects.size();
}

bool ProbePrograms::pending() const {
  return !with_.plan->interactive() && !moving_ && (!toPrepare_.empty() || !toFold_.empty());
}

void ProbePrograms::prepare(std::size_t object, std::shared_ptr<const ProbeBinding> binding) {
  if (binding) toPrepare_.emplace_back(object, std::move(binding));
}

void ProbePrograms::allowStandIns(bool allowed) {
  if (standInsAllowed_ == allowed) return;
  standInsAllowed_ = allowed;
  with_.binder->assign();
}

bool ProbePrograms::setMoving(bool moving) {
  moving_ = moving && standInsAllowed_;
  updateStandIns();
  const auto& objects = with_.content->objects;
  const bool any = std::any_of(objects.begin(), objects.end(), [](const DrawnObject& object) {
    return object.settings.visible && object.pass->GetDrawnBinding() != object.pass->GetBinding();
  });
  moving_ = moving_ && any;
  return any;
}

void ProbePrograms::updateStandIns() {
  const bool show = moving_ && !with_.plan->capturesLast();
  for (DrawnObject& object : with_.content->objects) {
    const auto cheap = show && object.pass->GetBinding() ? object.pass->GetBinding()->standIn() : nullptr;
    object.pass->SetStandIn(cheap && prepared_.count(cheap->variantKey() + "/" + object.materialName) > 0);
  }
}

// Draws one object into a few pixels with the program a drag will need, so that it is compiled by then.
void ProbePrograms::prepareOne() {
  if (toPrepare_.empty()) return foldNext();
  auto [index, general] = std::move(toPrepare_.back());
  toPrepare_.pop_back();
  DrawnObject& object = with_.content->objects[index];
  if (!object.settings.visible || !prepared_.insert(general->variantKey() + "/" + object.materialName).second) return;
  const auto binding = object.pass->GetSharedBinding();
  variantsUsed_.insert(general->variantKey());
  const bool apart = object.pass->GetSeparateSpecular();
  object.pass->SetSeparateSpecular(apart && general->blurredSamples() > 0);
  object.pass->SetBinding(std::move(general));
  CaptureSettings settings;
  settings.originWorld = worldBounds(object).center();
  with_.baker->capture()->drawOnce(settings, {object.actor}, with_.content->lightPointers());
  object.pass->SetBinding(binding);
  object.pass->SetSeparateSpecular(apart);
}

}  // namespace boxprobe
