#include "filters/vtk/probes/driver_tuning.h"

#include <vtkProperty.h>

#include <algorithm>
#include <map>
#include <new>

#include "filters/vtk/gl/software_driver.h"
#include "filters/vtk/probes/probe_baker.h"
#include "filters/vtk/probes/probe_binder.h"
#include "filters/vtk/scene/scene_content.h"
#include "filters/vtk/surface/draw_numbers.h"

namespace boxprobe {

namespace {

// The last level of a filtered chain has 4 texels along a face, as gpu/probe_lighting.glsl assumes.
bool endsAtFour(const CubeTexture& chain) {
  return chain.faceSize() >> (chain.levels() - 1) == 4;
}

// The key of an object's program without facts and constants.
std::string generalProgram(const DrawnObject& object) {
  const ProbeBinding* binding = object.pass->GetBinding();
  return object.surface->programKey() + (object.actor->GetProperty()->GetCoatStrength() > 0.0 ? "c" : "") +
         (object.pass->GetMirror() ? "m" : "") + (binding != nullptr ? binding->variantKey() : "");
}

Constants numbersOf(const DrawnObject& object) {
  Constants numbers;
  readLighting(numbers, *object.pass->GetDrawState(), *object.pass->GetDrawnBinding());
  readMaterial(numbers, *object.surface, object.actor->GetProperty());
  return numbers;
}

SurfaceFacts plannedFacts(const DrawnObject& object) {
  return object.pass->GetRequestedFacts() & surfaceFacts(*object.surface, object.actor->GetProperty());
}

}  // namespace

ProgramTraits DriverTuning::choose(const TunedDraw& draw) {
  DrawState& state = *with_.state;
  const PassSettings& pass = state.pass();
  ProgramTraits traits;
  if (draw.surface != nullptr && draw.picture && (parts_ & kTunedFacts) != 0) {
    traits.facts = draw.request.facts & surfaceFacts(*draw.surface, draw.actor->GetProperty());
  }
  if (!draw.binding || !draw.picture) return traits;
  const bool tuned = (parts_ & kTunedFirstBounce) != 0;
  if (tuned && pass.firstBounce && pass.firstBouncePrograms && !draw.samplesOtherPictures) {
    const bool same = draw.made.firstBounceOf == draw.binding;
    traits.firstBounce = same ? draw.made.firstBounce : draw.binding->forFirstBounce();
    traits.firstBounceOf = draw.binding;
    if (traits.firstBounce) {
      ++state.counts.counters.objectsUnlit;
      return traits;
    }
  }
  // Whether constants are still valid is checked against the values themselves, so edits need no notification.
  const std::shared_ptr<const ConstantsPlan>& plan = draw.request.constants;
  if (plan && !draw.refused && draw.surface != nullptr && plan->variant == draw.variant) {
    ConstantsCheck check(plan->values);
    readLighting(check, state, *draw.binding);
    readMaterial(check, *draw.surface, draw.actor->GetProperty());
    if (check.hold()) traits.constants = plan;
  }
  if (draw.made.constants && !traits.constants && pass.countDraws) ++state.counts.counters.constantsLeft;
  traits.flatMaps = traits.constants && (parts_ & kTunedFlatMaps) != 0 && makeFlatMaps(*draw.binding);
  return traits;
}

// Makes flat pictures of the maps that the binding samples, unless they exist, and counts each. False if it must use
// cubemaps, because one of them has no such picture (it is not captured yet, for instance) or memory is short. The sky
// needs none if no draw of the binding samples it.
bool DriverTuning::makeFlatMaps(const ProbeBinding& binding) {
  DrawState& state = *with_.state;
  if (!onCpu_) onCpu_ = tunedForCpu();
  if (!*onCpu_ || state.pass().firstBounce || binding.lighting != Lighting::Probes) return false;
  std::vector<const ProbeMaps*> all;
  if (binding.sky || binding.open()) all.push_back(state.resources.sky.get());
  for (std::size_t i = 0; i < binding.probes.size(); ++i) all.push_back(binding.lookedUp(i, state.pass().capture));
  std::size_t more = 0;
  for (const ProbeMaps* maps : all) {
    if (maps == nullptr || !FlatTexture::fits(maps->radiance) || !endsAtFour(maps->radiance)) return false;
    more += maps->flat.bytesToMake(maps->radiance);
  }
  if (more > 0 && *flatBytes_ + more > FlatTexture::kMostBytes) return false;
  return std::all_of(all.begin(), all.end(), [this](const ProbeMaps* maps) {
    const bool before = maps->flat.handle() != 0;
    const bool there = maps->flat.make(maps->radiance, flatBytes_);
    if (there && !before) ++with_.state->counts.counters.mapsFlattened;
    return there;
  });
}

std::uint64_t DriverTuning::uses(vtkShaderProgram* program, bool constants) {
  with_.state->counts.counters.programsCompiled += cache_.use(program, constants) ? 1 : 0;
  return cache_.compilation(program);
}

void DriverTuning::frameEnded(vtkOpenGLRenderWindow* window) {
  with_.state->counts.counters.programsReleased += cache_.trim(window);
}

bool DriverTuning::known(const ProbeBinding& now, const ProbeBinding& next) const {
  const std::string key = next.variantKey();
  return now.variantKey() == key || variantsUsed_.count(key) != 0;
}

void DriverTuning::assigned() {
  toPrepare_.clear();
  dropConstants();
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
  planFacts();
}

void DriverTuning::replanned() {
  if (moving_) updateStandIns();
}

// Not while a handle is dragged: other facts may mean other programs.
void DriverTuning::planFacts() {
  if (with_.plan->interactive()) return;
  std::vector<FactUse> uses;
  for (const DrawnObject& object : with_.content->objects) {
    uses.push_back({generalProgram(object), surfaceFacts(*object.surface, object.actor->GetProperty())});
  }
  const std::vector<SurfaceFacts> facts = boxprobe::planFacts(uses);
  for (std::size_t i = 0; i < facts.size(); ++i) with_.content->objects[i].pass->SetRequestedFacts(facts[i]);
}

void DriverTuning::dropConstants() {
  toMake_.clear();
  for (const DrawnObject& object : with_.content->objects) object.pass->SetConstants(nullptr);
}

void DriverTuning::makeConstants() {
  toMake_.clear();
  const auto& probes = with_.content->scene.probes;
  // A continuously captured probe never rests.
  const bool never =
      std::any_of(probes.begin(), probes.end(), [](const Probe& probe) { return probe.mode == ProbeMode::Realtime; });
  if (with_.plan->interactive() || moving_ || never || (parts_ & kTunedConstants) == 0) return;
  std::vector<std::size_t> objects;
  std::vector<ConstantUse> uses;
  std::set<std::string> general, withFacts;
  for (std::size_t i = 0; i < with_.content->objects.size(); ++i) {
    const DrawnObject& object = with_.content->objects[i];
    if (!object.settings.visible || object.pass->GetDrawnBinding() == nullptr) continue;
    const std::string program = generalProgram(object);
    general.insert(program);
    objects.push_back(i);
    uses.push_back({program + "/" + std::to_string(plannedFacts(object)), numbersOf(object)});
    withFacts.insert(uses.back().program);
  }
  const std::size_t most = general.size() + general.size() / 2;
  const auto plans = planConstants(uses, most > withFacts.size() ? most - withFacts.size() : 0);
  std::map<std::pair<std::string, const Constants*>, ConstantsJob> jobs;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (!plans[k]) continue;
    ConstantsJob& job = jobs[{uses[k].program, plans[k].get()}];
    job.objects.push_back(objects[k]);
    if (job.plan) continue;
    const std::string variant = with_.content->objects[objects[k]].pass->GetDrawnBinding()->variantKey();
    job.plan = std::make_shared<const ConstantsPlan>(ConstantsPlan{variant, *plans[k]});
  }
  for (auto& job : jobs) toMake_.push_back(std::move(job.second));
}

// If the driver refuses the program or memory is short, the current one stays.
void DriverTuning::makeNextConstants() {
  const ConstantsJob job = std::move(toMake_.back());
  toMake_.pop_back();
  const DrawnObject& first = with_.content->objects[job.objects.front()];
  first.pass->SetConstants(job.plan);
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
  for (const std::size_t object : job.objects) with_.content->objects[object].pass->SetConstants(job.plan);
  with_.state->counts.counters.constantsFolded += job.objects.size();
}

bool DriverTuning::pending() const {
  return !with_.plan->interactive() && !moving_ && (!toPrepare_.empty() || !toMake_.empty());
}

void DriverTuning::prepare(std::size_t object, std::shared_ptr<const ProbeBinding> binding) {
  if (binding) toPrepare_.emplace_back(object, std::move(binding));
}

void DriverTuning::allowStandIns(bool allowed) {
  if (standInsAllowed_ == allowed) return;
  standInsAllowed_ = allowed;
  with_.binder->assign();
}

bool DriverTuning::setMoving(bool moving) {
  moving_ = moving && standInsAllowed_;
  updateStandIns();
  const auto& objects = with_.content->objects;
  const bool any = std::any_of(objects.begin(), objects.end(), [](const DrawnObject& object) {
    return object.settings.visible && object.pass->GetDrawnBinding() != object.pass->GetBinding();
  });
  moving_ = moving_ && any;
  return any;
}

void DriverTuning::updateStandIns() {
  const bool show = moving_ && !with_.plan->capturesLast();
  for (DrawnObject& object : with_.content->objects) {
    const auto cheap = show && object.pass->GetBinding() ? object.pass->GetBinding()->standIn() : nullptr;
    object.pass->SetStandIn(cheap && prepared_.count(cheap->variantKey() + "/" + object.materialName) > 0);
  }
}

// Draws one object into a few pixels with the program that a drag will need, to compile it ahead.
void DriverTuning::prepareOne() {
  if (toPrepare_.empty()) return makeNextConstants();
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
