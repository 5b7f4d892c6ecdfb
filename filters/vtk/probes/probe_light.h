// What is worked out from the maps that probes show, beside the maps themselves: the sky's diffuse light through their
// openings, which lights their coverage stands before, the colour of the glass they see. Called when maps, the sky or
// shapes are others; starts no capture.
#pragma once

#include <memory>

#include "filters/vtk/probes/shown_probes.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

class ProbeLight {
 public:
  /// Both pointers must outlive this.
  ProbeLight(const SceneContent* content, std::shared_ptr<DrawState> state, ShownProbes* shown)
      : content_(content), state_(std::move(state)), shown_(shown) {}

  /// The scene's lights that ask for shadows, and for each probe those of them that lie outside of its box.
  void updateShadowLights();
  /// Which probes' diffuse light is that of lamps drawn as shapes and of a lattice, and of which lamps. Of
  /// pictures, whose lamps are not known, the lattice alone.
  void updateLamps();
  /// On the CPU from small levels, and only of maps or a sky that are new, so that another sky costs no capture.
  /// Returns whether a probe begins or ceases to let the sky through: that takes another program.
  bool updateOpenings();
  /// Adds to maps that are new what their coverage does not tell.
  void addTint(std::size_t index, const ProbeMaps& maps) const;

 private:
  const SceneContent* content_;
  std::shared_ptr<DrawState> state_;
  ShownProbes* shown_;
};

}  // namespace boxprobe
