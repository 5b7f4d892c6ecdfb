// The maps each probe and the sky are drawn with, where they belong, and what of them a capture sees while it is drawn.
// Changed by those who publish maps, read by draws through the objects' bindings; knows no keys and makes no maps.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/probes/probe_entries.h"

namespace boxprobe {

/// What a probe's errors were measured with.
struct MeasuredWith {
  std::string shown;
  glm::vec3 boxMin{0.0f}, boxMax{0.0f};
  glm::dmat3 mapFromProbe{1.0};
};

struct ShownProbe {
  std::shared_ptr<DrawnProbe> drawn = std::make_shared<DrawnProbe>();
  /// Maps of the probe and of the sky that the light of the sky through its openings was worked out from.
  std::pair<std::shared_ptr<const ProbeMaps>, std::shared_ptr<const ProbeMaps>> openSkyOf;
  MeasuredWith measured;
};

class ShownProbes {
 public:
  /// `scene` must outlive this.
  ShownProbes(const Scene* scene, std::shared_ptr<DrawState> state) : scene_(scene), state_(std::move(state)) {}

  /// Follows a change of the scene's list of probes.
  void rearrange(const ProbeEntries::Origins& origins);
  /// Takes over boxes, weights and techniques from the scene.
  void updateShapes();

  std::size_t size() const { return probes_.size(); }
  /// Changes whenever other maps may be shown.
  std::uint64_t generation() const { return generation_; }
  ShownProbe& operator[](std::size_t index) { return probes_[index]; }
  const ShownProbe& operator[](std::size_t index) const { return probes_[index]; }
  DrawnProbe& drawn(std::size_t index) { return *probes_[index].drawn; }
  const DrawnProbe& drawn(std::size_t index) const { return *probes_[index].drawn; }
  /// Is it one of these, at its index?
  bool has(const DrawnProbe& probe) const;
  /// All, as objects are given them.
  std::vector<std::shared_ptr<DrawnProbe>> all() const;

  /// Draws the probe with these maps from now on. Returns whether they are turned against its box as those before were
  /// not, or the other way round: that takes another program.
  bool show(std::size_t index, std::shared_ptr<const ProbeMaps> maps);

  /// Until seeAgain() every probe is drawn with the maps that `maps` has for it; null: it gives nothing.
  void see(const std::function<std::shared_ptr<const ProbeMaps>(std::size_t index)>& maps);
  void seeAgain();
  /// For a capture that must not change with the sky: the same function, called while there is no sky.
  std::function<void(bool)> withoutSky(std::function<void(bool)> drawing);

  void release();

 private:
  ProbeGeometry geometry(std::size_t index, const ProbeMaps* maps) const;

  struct Seen {
    std::shared_ptr<const ProbeMaps> maps;
    ProbeGeometry geometry;
  };
  const Scene* scene_;
  std::shared_ptr<DrawState> state_;
  std::vector<ShownProbe> probes_;  ///< in the order of scene.probes
  std::uint64_t generation_ = 0;
  std::vector<Seen> windowSees_;              ///< put aside while a capture sees other maps
  std::shared_ptr<const ProbeMaps> skyKept_;  ///< put aside while a capture goes without
};

}  // namespace boxprobe
