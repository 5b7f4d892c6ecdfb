// What is worked out from the maps that probes show, beside the maps themselves: the sky's diffuse light through their
// openings, which lights their coverage stands before, the colour of the glass they see. Called when maps, the sky or
// shapes are others; starts no capture.
#pragma once

#include <memory>

#include "filters/vtk/probes/shown_probes.h"
#include "filters/vtk/probes/sight_work.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

class ProbeLight {
 public:
  /// Both pointers must outlive this.
  ProbeLight(const SceneContent* content, std::shared_ptr<DrawState> state, ShownProbes* shown)
      : content_(content), state_(std::move(state)), shown_(shown) {}

  /// The scene's lights that ask for shadows, and for each probe those of them that lie outside of its box.
  void updateShadowLights();
  /// Which probes' diffuse light is that of lamps drawn as shapes and of a lattice, and of which lamps. Not of realtime
  /// probes and pictures, whose lamps are not known, nor of those that the sky shows through.
  void updateLamps();
  /// What is seen of lamps is traced, unless a box is dragged: captures wait for it.
  void holdSight(bool held);
  bool sightPending() const { return sight_.pending(); }
  /// Returns whether probes see their lamps otherwise than before, which takes other programs.
  bool makeSight();
  /// On the CPU from small levels, and only of maps or a sky that are new, so that another sky costs no capture.
  /// Returns whether a probe begins or ceases to let the sky through: that takes another program.
  bool updateOpenings();
  /// Adds to maps that are new what their coverage does not tell.
  void addTint(std::size_t index, const ProbeMaps& maps) const;

 private:
  void showSight();

  const SceneContent* content_;
  std::shared_ptr<DrawState> state_;
  ShownProbes* shown_;
  SightWork sight_;
};

}  // namespace boxprobe
