#include "filters/vtk/probes/sight_work.h"

#include <algorithm>

namespace boxprobe {

namespace {

// Bytes and time of all probes together stay bounded.
constexpr int kMostNodesOfAll = 8'000'000, kFewestNodes = 1000;
// Captures are coarse, and are looked at in reflections.
constexpr double kCaptureSpacing = 0.5;
constexpr int kMostCaptureNodes = 4096;

SightSettings ofCapture(SightSettings settings) {
  settings.spacing = kCaptureSpacing;
  settings.mostNodes = std::min(settings.mostNodes, kMostCaptureNodes);
  return settings;
}

}  // namespace

void SightWork::ask(std::vector<std::optional<SightTask>> tasks, const Scene& scene, const Models& models,
                    const SightLinesMaker& lines) {
  Surroundings surroundings;
  const bool any = lines && std::any_of(tasks.begin(), tasks.end(), [](const auto& task) { return task.has_value(); });
  if (any) {
    surroundings.models = models;
    surroundings.files = scene.models;
    for (const auto& [node, object] : scene.objects) {
      ObjectOverride placed;
      placed.visible = object.visible;
      placed.dynamic = object.dynamic;
      placed.seenByProbes = object.seenByProbes;
      placed.translation = object.translation;
      placed.rotationDegrees = object.rotationDegrees;
      if (!(placed == ObjectOverride{})) surroundings.objects.emplace(node, placed);
    }
    for (const auto& model : models) {
      for (const Material& material : model->materials) {
        const auto found = scene.materials.find(material.name);
        if (found == scene.materials.end() || !found->second.emissive) continue;
        const bool shines = *found->second.emissive != glm::vec3(0.0f);
        if (shines != (material.emissive != glm::vec3(0.0f))) surroundings.shining[material.name] = shines;
      }
    }
  } else {
    for (auto& task : tasks) task.reset();
  }
  const bool same = surroundings == surroundings_;
  // Colours change what a lattice's rays bring from where they end, but nothing of what is seen.
  Looks looks = any ? looksOf(scene) : looks_;
  const bool sameLooks = looks == looks_;
  std::vector<Known> known(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    Known& now = known[i];
    now.task = std::move(tasks[i]);
    if (!now.task) {
      now.current = true;
      continue;
    }
    const auto equal = std::find_if(known_.begin(), known_.end(), [&](const Known& before) {
      return before.sight && before.task && *before.task == *now.task;
    });
    if (equal != known_.end()) {
      now.sight = equal->sight;
      now.current = same && equal->current;
    } else if (i < known_.size() && known_[i].task && known_[i].task->lamps == now.task->lamps &&
               known_[i].task->sources == now.task->sources &&
               known_[i].task->from.has_value() == now.task->from.has_value()) {
      now.sight = known_[i].sight;
    }
  }
  const bool unchanged = same && sameLooks && known.size() == known_.size() &&
                         std::equal(known.begin(), known.end(), known_.begin(), [](const Known& a, const Known& b) {
                           return a.task == b.task && a.current == b.current;
                         });
  if (unchanged) return;  // what runs is still what is asked for
  known_ = std::move(known);
  cancel();
  if (!same) lines_.reset();
  looks_ = std::move(looks);
  otherLooks_ = lines_ && (otherLooks_ || !sameLooks);
  surroundings_ = std::move(surroundings);
  open_ = false;
  maker_ = lines;
  const bool left = std::any_of(known_.begin(), known_.end(), [](const Known& k) { return !k.current; });
  scene_ = (left && !lines_) || otherLooks_ ? std::make_shared<const Scene>(scene) : nullptr;
}

SightWork::Looks SightWork::looksOf(const Scene& scene) {
  Looks looks;
  for (const auto& [name, material] : scene.materials) {
    if (material.baseColor || material.emissive) looks[name] = {material.baseColor, material.emissive};
  }
  return looks;
}

bool SightWork::anyOpen() const {
  return std::any_of(known_.begin(), known_.end(), [](const Known& known) { return known.open(); });
}

bool SightWork::anyWanted() const {
  return std::any_of(known_.begin(), known_.end(), [](const Known& known) { return known.wanted && known.task; });
}

void SightWork::want(const std::vector<bool>& tasks) {
  for (std::size_t i = 0; i < known_.size(); ++i) known_[i].wanted = i < tasks.size() && tasks[i];
  open_ = anyOpen() || (otherLooks_ && anyWanted());
}

SightWork::~SightWork() {
  cancel();
  for (const auto& ending : ending_) ending.wait();
}

void SightWork::cancel() {
  if (!running_.valid()) return;
  *cancelled_ = true;
  ending_.push_back(std::move(running_));
}

// By all tasks, so that a lattice does not depend on which are wanted first.
SightSettings SightWork::settings() const {
  const auto count =
      std::count_if(known_.begin(), known_.end(), [](const Known& k) { return k.task && !k.task->from; });
  SightSettings settings;
  settings.mostNodes =
      std::clamp(kMostNodesOfAll / std::max(static_cast<int>(count), 1), kFewestNodes, settings.mostNodes);
  return settings;
}

std::size_t SightWork::bytes() const {
  const SightSettings most = settings();
  std::size_t bytes = 0;
  for (const Known& known : known_) {
    if (!known.wanted || !known.task) continue;
    if (known.current) {
      bytes += known.sight ? known.sight->lattice.texels.size() : 0;
      continue;
    }
    const SightTask& task = *known.task;
    std::size_t nodes = kMostCaptureNodes;  // its box is what is seen
    if (!task.from) {
      const glm::ivec3 along = sightNodes(task.box.size() + task.reach.low + task.reach.high, most);
      nodes = static_cast<std::size_t>(along.x * along.y * along.z);
    }
    const std::size_t lamps = std::min(task.lamps.size(), std::max<std::size_t>(task.own, kMostProbeLamps));
    if (lamps + task.sources.size() == 0) continue;
    bytes += nodes * ((1 + lamps + task.sources.size() + 3) / 4 * 4);
  }
  return 2 * bytes;
}

void SightWork::start() {
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  std::vector<std::optional<SightTask>> tasks;
  traced_.clear();
  for (const Known& known : known_) {
    traced_.push_back(known.open());
    tasks.push_back(known.open() ? known.task : std::nullopt);
  }
  running_ = std::async(
      std::launch::async, [tasks = std::move(tasks), scene = scene_, models = surroundings_.models, maker = maker_,
                           lines = otherLooks_ ? nullptr : lines_, cancelled = cancelled_, settings = settings()] {
        Done done{lines, {}};
        done.sights.resize(tasks.size());
        if (!done.lines) done.lines = maker(*scene, models);
        for (std::size_t i = 0; i < tasks.size() && !*cancelled; ++i) {
          if (!tasks[i]) continue;
          SightTask task = *tasks[i];
          SightSettings of = settings;
          if (task.from) {
            task.box = boxSeenFrom(*done.lines, *task.from);
            of = ofCapture(settings);
          } else {
            task.box = openBox(*done.lines, task);
          }
          done.sights[i] = std::make_shared<const ProbeSight>(probeSight(*done.lines, task, *cancelled, of));
        }
        return done;
      });
}

bool SightWork::proceed(std::chrono::milliseconds wait) {
  if (!pending()) return false;
  while (!ending_.empty()) {
    if (ending_.back().wait_for(wait) != std::future_status::ready) return false;
    ending_.pop_back();
  }
  if (!running_.valid()) start();
  if (running_.wait_for(wait) != std::future_status::ready) return false;
  for (std::size_t i = 0; i < known_.size() && i < traced_.size(); ++i) {
    known_[i].current = known_[i].current || traced_[i];
  }
  open_ = anyOpen();
  otherLooks_ = false;
  const Done done = running_.get();
  lines_ = done.lines;
  made_.clear();
  for (std::size_t i = 0; i < known_.size() && i < done.sights.size(); ++i) {
    if (!done.sights[i]) continue;
    known_[i].sight = done.sights[i];
    made_.push_back({done.sights[i], known_[i].task && known_[i].task->from.has_value()});
  }
  scene_.reset();
  return true;
}

std::shared_ptr<const ProbeSight> SightWork::of(std::size_t task) const {
  return task < known_.size() ? known_[task].sight : nullptr;
}

}  // namespace boxprobe
