// Who is lit by what: the maps that each probe and the sky are drawn with and where they belong, what follows from
// these (light through openings, lamps, shadows by coverage, errors of techniques), and which probes each object is
// drawn with. Changed by those who publish maps, read by draws through the objects' bindings; knows no keys of maps
// and makes none.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "filters/core/geometry/probe_index.h"
#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/probes/probe_context.h"
#include "filters/vtk/probes/probe_plan.h"
#include "filters/vtk/probes/sight_work.h"

namespace boxprobe {

struct DrawnObject;
class ProbeBinder;

/// Which mip levels of each probe and of the sky the materials of the scene sample, so that no other is filtered; and
/// which of those that are shown lack one.
class LevelNeeds {
 public:
  /// All must outlive this.
  LevelNeeds(const SceneContent* content, const ProbeBinder* shown, const DrawState* state)
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
  /// Pictures are refined by rays, which sample all levels.
  void setRefined(bool refined);
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
  const ProbeBinder* shown_;
  const DrawState* state_;
  bool all_ = false, refined_ = false;
  std::vector<Need> needs_;  ///< of each probe
  Need sky_;
  std::weak_ptr<const ProbeMaps> alsoOf_;
  LevelMask also_ = 0;
  // Nothing was lacking when these were what was shown.
  mutable std::uint64_t wholeShown_ = ~std::uint64_t{0};
  mutable const ProbeMaps* wholeSky_ = nullptr;
  mutable bool whole_ = false;
};

class ProbeBinder {
 public:
  /// `with` and all that it points to must outlive this.
  explicit ProbeBinder(const ProbeContext& with) : with_(with), needs_(with.content, this, with.state.get()) {}

  // What probes are drawn with.
  /// Follows a change of the scene's list of probes.
  void rearrange(const ProbeEntries::Origins& origins);
  /// Takes over boxes, weights, techniques and lights from the scene; assign() follows.
  void updateShapes();
  std::size_t size() const { return probes_.size(); }
  /// Changes whenever other maps may be shown.
  std::uint64_t generation() const { return generation_; }
  const DrawnProbe& drawn(std::size_t index) const { return *probes_[index].drawn; }
  /// Is it one of these, at its index?
  bool has(const DrawnProbe& probe) const;
  /// Draws the probe with these maps from now on; null: it gives nothing. Objects get other programs where that takes
  /// any.
  void show(std::size_t index, std::shared_ptr<const ProbeMaps> maps);
  void showSky(std::shared_ptr<const ProbeMaps> maps);
  /// Adds to maps that are new what their coverage does not tell.
  void addTint(std::size_t index, const ProbeMaps& maps) const;

  /// What is seen of lamps is traced, unless a box is dragged: captures wait for it.
  void holdSight(bool held) { sight_.hold(held); }
  bool sightPending() const { return sight_.pending(); }
  /// Of the probes that the plan asks for, and of no other: called whenever that may have changed.
  void wantSight();
  /// Begins that or waits a little. True: probes see their lamps otherwise than before, and assign() follows. Throws
  /// WorkError.
  bool makeSight();

  // What a capture sees while it is drawn.
  /// Until seeAgain() every probe is drawn with the maps that `maps` has for it; null: it gives nothing.
  void see(const std::function<std::shared_ptr<const ProbeMaps>(std::size_t index)>& maps);
  void seeAgain();
  /// For a capture that must not change with the sky: the same function, called while there is no sky.
  std::function<void(bool)> withoutSky(std::function<void(bool)> drawing);

  // Which object is lit by which probe.
  /// Gives every object the probes whose influence meets it; during a drag only as far as there are programs for it
  /// already, unless `anyProgram`.
  void assign(bool anyProgram = false);
  /// The same for one object, whatever it takes.
  void assign(std::size_t object);
  /// The probes whose influence box meets the object's bounds, most important first (equal importance by name, never by
  /// the order in the file), at most ProbeBinding::kMaxProbesPerDraw. `general`: by a program that stays right wherever
  /// in its influence a box is dragged to.
  std::shared_ptr<const ProbeBinding> bindingOf(const DrawnObject& object, bool general) const;
  /// Which mip levels the objects sample.
  LevelNeeds& needs() { return needs_; }
  const LevelNeeds& needs() const { return needs_; }

  // How wrong the techniques are that `auto` chooses from, measured with a probe's own final picture in its own box:
  // once after a bake and after a drag, never during one.
  /// The first probe whose errors are those of another picture or box.
  std::optional<std::size_t> toMeasure() const;
  /// Objects are assigned again: what they are drawn with may change by it.
  void measure(std::size_t index);

  void release();

 private:
  struct Shown {
    std::shared_ptr<DrawnProbe> drawn = std::make_shared<DrawnProbe>();
    /// Maps of the probe and of the sky that the light of the sky through its openings was worked out from.
    std::pair<std::shared_ptr<const ProbeMaps>, std::shared_ptr<const ProbeMaps>> openSkyOf;
    /// What the probe's errors were measured with.
    std::string measuredKey;
    glm::vec3 measuredMin{0.0f}, measuredMax{0.0f};
    glm::dmat3 measuredMapFromProbe{1.0};
  };
  struct Seen {
    std::shared_ptr<const ProbeMaps> maps;
    ProbeGeometry geometry;
  };
  ProbeGeometry geometry(std::size_t index, const ProbeMaps* maps) const;
  void updateShadowLights();
  void updateLamps();
  void showSight();
  bool updateOpenings();
  bool errorsStale(std::size_t index) const;
  void recordUse();

  const ProbeContext& with_;
  LevelNeeds needs_;
  std::vector<Shown> probes_;  ///< in the order of scene.probes
  ProbeIndex places_;          ///< of their influence boxes
  SightWork sight_;
  std::uint64_t generation_ = 0;
  std::vector<Seen> windowSees_;              ///< put aside while a capture sees other maps
  std::shared_ptr<const ProbeMaps> skyKept_;  ///< put aside while a capture goes without
};

}  // namespace boxprobe
