// Which mip levels of each probe and of the sky the materials of the scene sample, so that no other is filtered; and
// which of those that are shown lack one. Told by the assignment how objects are drawn; called by captures and by the
// probe set.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "filters/vtk/probes/shown_probes.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

class LevelNeeds {
 public:
  /// All must outlive this.
  LevelNeeds(const SceneContent* content, const ShownProbes* shown, const DrawState* state)
      : content_(content), shown_(shown), state_(state) {}

  /// Looks at all objects as they are drawn now. O(objects and their probes).
  void update();
  /// Whether what is captured from now on gets every level, as files do, whatever samples it. Maps that are there stay.
  void setAll(bool all) { all_ = all; }

  /// Of a chain of so many levels; all, for a probe that is not in the list.
  LevelMask ofProbe(std::size_t probe, int levels) const;
  LevelMask ofSky(int levels) const;

  /// Levels that something beside the scene's objects samples; of one chain at a time, null for none.
  void also(const std::shared_ptr<const ProbeMaps>& maps, LevelMask levels);
  /// How many levels are lacking.
  int left() const;

  /// Does something that is shown lack a level it needs? Cheap while nothing changes.
  bool lacking() const;
  /// Filters one such level, with the window's context current; nothing where none is lacking. True if the scene's
  /// objects needed it, not only what also() told of.
  bool makeOne();

 private:
  struct Lookup {
    Technique technique;
    double low = 0.0, high = 0.0;  ///< roughness
    bool operator==(const Lookup& o) const { return technique == o.technique && low == o.low && high == o.high; }
  };
  struct Need {
    bool all = false;
    std::vector<Lookup> lookups;
    void add(const Lookup& lookup);
  };
  struct Lack {
    const ProbeMaps* maps;
    LevelMask levels;
  };
  LevelMask sampledOf(std::size_t probe, int levels) const;
  LevelMask sampledOfSky(int levels) const;
  std::optional<Lack> find() const;
  /// Calls `each(maps, levels)` for what lacks levels, until it returns false.
  template <typename Each>
  void forEachLack(const Each& each) const;

  const SceneContent* content_;
  const ShownProbes* shown_;
  const DrawState* state_;
  bool all_ = false;
  std::vector<Need> needs_;  ///< of each probe
  Need sky_;
  std::weak_ptr<const ProbeMaps> alsoOf_;
  LevelMask also_ = 0;
  // Nothing was lacking when these were what was shown.
  mutable std::uint64_t wholeShown_ = ~std::uint64_t{0};
  mutable const ProbeMaps* wholeSky_ = nullptr;
  mutable bool whole_ = false;
};

}  // namespace boxprobe
