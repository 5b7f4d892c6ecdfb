// The probes of a scene at work: which maps each one shows, which are stale, the queue that makes them, those kept for
// undo, and which object uses which probe. Lazy: a probe no visible object uses is not captured. Owned by the scene
// renderer.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "filters/vtk/bake_queue.h"
#include "filters/vtk/scene_content.h"

namespace boxprobe {

class ProbeSet {
 public:
  ProbeSet(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, CubeCapture* capture, SceneContent* content,
           Times* times);

  /// Takes over boxes, weights and techniques from the scene: uniforms only.
  void updateShapes();
  /// Gives every object the probes whose influence meets it; during a drag only as far as there are programs for it
  /// already.
  void assignToObjects();
  /// Finds out which captures an edit has made stale; shows maps made before where there are any; starts or stops work.
  void updateCaptures();

  void setInteractive(bool interactive);
  void setEnabled(bool enabled);
  /// Someone may start to drag a box: the programs that takes are compiled ahead, as work of the lowest priority.
  void setEditable(bool editable) { editable_ = editable; }

  bool workPending() const { return queue_.pending() || stale() || preparationPending(); }
  void step();
  double progress() const { return queue_.pending() ? queue_.progress() : (stale() ? 0.0 : 1.0); }

  /// What a probe shows now; null while it has none, or if there is no such probe.
  std::shared_ptr<const ProbeMaps> maps(const std::string& probeName) const;

  std::size_t memoryBytes() const;
  void release();

 private:
  struct Entry {
    std::string name;
    std::shared_ptr<DrawnProbe> drawn = std::make_shared<DrawnProbe>();
    std::string shown;   ///< key of the maps it shows
    std::string wanted;  ///< key of those it should
    bool used = false;   ///< some visible object lies in its influence
  };
  struct CachedMaps {
    std::string key;
    std::shared_ptr<const ProbeMaps> maps;
  };

  void matchEntries();
  void assign(bool newProgramsAllowed);
  bool preparationPending() const { return !interactive_ && !toPrepare_.empty(); }
  void prepareOne();
  bool stale() const;
  bool stale(const Entry& entry) const;
  void startWork();
  BakeItem skyItem();
  BakeItem probeItem(std::size_t index);
  void show(Entry& entry, const Probe& probe, const std::string& key, std::shared_ptr<const ProbeMaps> maps);
  std::shared_ptr<const ProbeMaps> cached(const std::string& key) const;
  void remember(const std::string& key, std::shared_ptr<const ProbeMaps> maps);

  std::shared_ptr<DrawState> state_;
  SceneContent* content_;
  CubeCapture* capture_;
  BakeQueue queue_;
  bool enabled_ = true;
  bool interactive_ = false;
  bool editable_ = false;

  std::vector<Entry> entries_;  ///< in the order of scene.probes
  std::string skyWanted_, skyShown_;
  std::vector<std::string> queued_;     ///< keys the queue works towards
  std::set<std::string> variantsUsed_;  ///< program variants objects have had so far
  std::vector<std::pair<std::size_t, std::shared_ptr<const ProbeBinding>>>
      toPrepare_;  ///< object, its binding in a drag
  std::set<std::string> prepared_;
  std::vector<CachedMaps> cache_;  ///< most recently made last
};

}  // namespace boxprobe
