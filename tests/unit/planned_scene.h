// A scene whose probes are planned without a window: objects are boxes, maps are nothing but their keys. For tests of
// the plan; what it does when a job is done is what ProbeBaker does with maps.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "filters/vtk/probes/probe_plan.h"

namespace boxprobe::test {

/// A probe whose box is the cube of that half size around its origin.
inline Probe probeAt(const std::string& name, const glm::dvec3& origin, double half, int bounces = 1) {
  Probe probe;
  probe.name = name;
  probe.origin = origin;
  probe.box = {origin - half, origin + half};
  probe.faceSize = 32;
  probe.bounces = bounces;
  return probe;
}

/// A cube; `lit`: its material takes light.
inline PlacedObject cubeAt(const std::string& node, const glm::dvec3& center, double half, bool lit = true) {
  PlacedObject object;
  object.node = node;
  object.materialName = node + " material";
  object.contentKey = node + " geometry";
  object.boundsWorld = {center - half, center + half};
  object.unlit = !lit;
  return object;
}

class PlannedScene {
 public:
  Scene scene;
  std::vector<PlacedObject> objects;
  std::set<std::string> notDrawnByProbes;  ///< nodes of objects that are drawn without any
  std::set<std::string> hidden;            ///< nodes of objects that are not drawn
  std::set<std::string> cache;             ///< keys of maps at hand
  std::vector<FaceKeys> facesMade;         ///< of each bounce that was made, in order

  ProbePlan plan{&scene, [this](const std::string& key) { return cache.count(key) != 0; }};
  ProbeSources& sources = plan.sources();
  ProbeEntries& entries = plan.entries();

  PlannedScene() = default;
  PlannedScene(const PlannedScene&) = delete;
  PlannedScene& operator=(const PlannedScene&) = delete;

  /// After an edit: as the probe set does for all kinds of changes.
  void update() {
    entries.match();
    std::vector<ObjectUse> uses;
    for (const PlacedObject& object : objects) {
      ObjectUse use{!object.unlit && hidden.count(object.node) == 0, {}};
      if (!object.unlit && notDrawnByProbes.count(object.node) == 0)
        use.probes = entries.places().meeting(object.boundsWorld);
      uses.push_back(std::move(use));
    }
    entries.setUse(std::move(uses));
    plan.setWorld(captureWorld(scene, objects, "", entries.places()));
    sources.pictures.update(scene);
    plan.updateKeys();
    plan.wantSky(plan.world().sky, 0);
    replan();
  }

  /// Shows maps at hand and plans the rest.
  void replan() {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (entries[i].wanted.empty() || cache.count(entries[i].wanted) == 0) continue;
      if (entries[i].shown != entries[i].wanted) entries[i].fromFile = false;
      entries[i].shown = entries[i].wanted;
    }
    if (plan.skyStale() && cache.count(plan.skyWanted()) != 0) plan.skyShows(plan.skyWanted());
    plan.make();
    if (!plan.keepsCurrent()) plan.end();
  }

  /// The jobs planned, one word each: the kind, the probe's name and, of bounces, which one.
  std::vector<std::string> jobs() const {
    std::vector<std::string> words;
    for (const ProbeJob& job : plan.jobs()) words.push_back(word(job));
    return words;
  }
  static std::string word(const ProbeJob& job) {
    static const char* const kinds[] = {"sky", "file", "picture", "drag", "bounce", "realtime", "levels", "coarse"};
    std::string kind = kinds[static_cast<std::size_t>(job.kind)];
    if (job.name.empty()) return kind;
    return kind + ":" + job.name + (job.kind == JobKind::Bounce ? std::to_string(job.bounce) : "");
  }

  /// Does the first job.
  void makeNext() {
    const ProbeJob job = plan.jobs().front();
    plan.begin(job);
    FaceKeys faces;
    const auto index = entries.find(job.name);
    for (int f = 0; index && f < 6; ++f) {
      std::string& key = faces[static_cast<std::size_t>(f)];
      if (job.kind == JobKind::Bounce) key = plan.faceKey(*index, job.bounce, f);
      if (job.kind == JobKind::Realtime) key = plan.realtimeFaceKey(entries.probe(*index), f);
    }
    plan.end();
    if (!index) {
      plan.skyShows(job.key);
      cache.insert(job.key);
    } else if (job.kind == JobKind::Drag) {
      entries[*index].shown = job.key;
    } else if (job.kind == JobKind::Realtime) {
      showRealtime(entries[*index], ProbePlan::realtimeKey(entries.probe(*index), faces), faces);
    } else {
      showFinal(*index, job);
    }
    if (job.kind == JobKind::Bounce) facesMade.push_back(faces);
    replan();
  }
  /// Does all that is planned; returns the words of what was done.
  std::vector<std::string> makeAll() {
    std::vector<std::string> done;
    while (!plan.jobs().empty() && done.size() < 100) {
      done.push_back(word(plan.jobs().front()));
      makeNext();
    }
    return done;
  }

  /// Which faces of b are those of a: six letters, `=` or `x`.
  static std::string kept(const FaceKeys& a, const FaceKeys& b) {
    std::string text;
    for (std::size_t f = 0; f < 6; ++f) text += !b[f].empty() && a[f] == b[f] ? '=' : 'x';
    return text;
  }

 private:
  static void showRealtime(ProbeEntry& entry, const std::string& key, const FaceKeys& faces) {
    if (key == entry.wanted && entry.shown == key && entry.passes > 0) --entry.passes;
    entry.shown = key;
    entry.faces = faces;
    entry.again = false;
  }
  void showFinal(std::size_t index, const ProbeJob& job) {
    ProbeEntry& entry = entries[index];
    const bool last = job.key == entry.wanted;
    if (last || plan.stale(index)) entry.shown = job.key;
    if (last) {
      entry.again = false;
      entry.fromFile = job.kind == JobKind::File;
      plan.remember(index);
    }
    cache.insert(job.key);
  }
};

}  // namespace boxprobe::test
