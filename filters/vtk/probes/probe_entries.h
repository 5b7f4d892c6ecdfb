// What each probe of a scene shows and should show, by the keys of its maps, and whether anything that is drawn is lit
// by it. Read by the plan, written by whoever shows maps; knows keys and indices, neither maps nor OpenGL nor VTK.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "filters/core/geometry/probe_index.h"
#include "filters/core/scene/scene.h"
#include "filters/vtk/maps/face_keys.h"

namespace boxprobe {

struct ProbeEntry {
  std::string name;
  std::string shown;      ///< key of the maps it shows; empty: it shows none
  std::string wanted;     ///< key of those it should show; empty: there is nothing it could show
  FaceKeys faces;         ///< realtime: of the faces it shows
  int passes = 0;         ///< realtime: further rounds until mirrors in mirrors have settled
  bool used = false;      ///< some visible object is lit by it
  bool seen = true;       ///< some object of the last frame is, or there are so few that all are made at once
  bool again = false;     ///< asked for although nothing changed: no face is kept
  bool fromFile = false;  ///< what it shows was read from a file
  bool needed() const { return (used && seen) || again; }
};

/// How one object is drawn.
struct ObjectUse {
  bool lit = false;                 ///< visible, and its material takes light
  std::vector<std::size_t> probes;  ///< those that light it, as indices into scene.probes
};

class ProbeEntries {
 public:
  /// For each probe of the list the index it had before; nothing: it is new.
  using Origins = std::vector<std::optional<std::size_t>>;

  /// `scene` must outlive this.
  explicit ProbeEntries(const Scene* scene) : scene_(scene) {}

  /// Follows scene.probes: a probe keeps its entry through a change of the list; a renamed one is new, and finds its
  /// maps again by key. Nothing is returned where the list has the names it had.
  std::optional<Origins> match();
  /// Does the scene's list have the names these entries were matched with?
  bool matched() const;

  std::size_t size() const { return entries_.size(); }
  ProbeEntry& operator[](std::size_t index) { return entries_[index]; }
  const ProbeEntry& operator[](std::size_t index) const { return entries_[index]; }
  const Scene& scene() const { return *scene_; }
  const Probe& probe(std::size_t index) const { return scene_->probes[index]; }
  bool baked(std::size_t index) const { return probe(index).mode == ProbeMode::Baked; }
  std::optional<std::size_t> find(const std::string& name) const;
  /// Where the influence boxes lie, as of the last match().
  const ProbeIndex& places() const { return places_; }

  /// How all objects are drawn, in the scene's order: a probe that reaches an object but was left out of it lights
  /// nothing there.
  void setUse(std::vector<ObjectUse> objects);
  /// Which objects the last frame showed, as indices; nothing: not known, as if all were. Of many probes those alone
  /// are seen that light one of these. Returns whether that changed for a probe.
  bool setSeen(std::optional<std::vector<std::size_t>> objects);
  /// Is any object lit?
  bool anyLit() const;

 private:
  bool findSeen();

  const Scene* scene_;
  std::vector<ProbeEntry> entries_;  ///< in the order of scene.probes
  std::unordered_map<std::string, std::size_t> byName_;
  ProbeIndex places_;
  std::vector<ObjectUse> objects_;
  std::optional<std::vector<std::size_t>> seenObjects_;
};

}  // namespace boxprobe
