// Binds probes to objects: the maps that each probe and the sky are drawn with, their derived properties (light through
// openings, lamps, shadows by coverage, errors of techniques), and the probes of each object. Does not make maps.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
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

/// Which mip levels of each probe and of the sky the scene's materials sample, so that no other is filtered, and which
/// of those are missing in the maps that are shown.
class LevelNeeds {
 public:
  /// All must outlive this object.
  LevelNeeds(const SceneContent* content, const ProbeBinder* shown, const DrawState* state)
      : content_(content), shown_(shown), state_(state) {}

  /// Examines all objects as they are drawn now. O(objects and their probes).
  void update();
  /// Filters all levels of future captures, as for files, whether or not they are sampled. Does not affect existing
  /// maps.
  void setAll(bool all) { all_ = all; }

  /// For a chain of that many levels; all levels for a probe that is not in the list.
  LevelMask ofProbe(std::size_t probe, int levels) const;
  LevelMask ofSky(int levels) const;

  /// Levels that something besides the scene's objects samples; for one chain at a time, null for none.
  void also(const std::shared_ptr<const ProbeMaps>& maps, LevelMask levels);
  /// Refined pictures use rays, which sample all levels.
  void setRefined(bool refined);
  /// Number of missing levels.
  int left() const;

  /// Is a level missing that something shown needs? Cheap if nothing has changed.
  bool lacking() const;
  /// Filters one such level, if any, with the window's context current. True if the scene's objects needed it, not only
  /// also().
  bool makeOne();

 private:
  struct Lookup {
    Technique technique;
    double low = 0.0, high = 0.0;  ///< range of roughness
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
  /// Calls `each(maps, levels)` for maps with missing levels, until it returns false.
  template <typename Each>
  void forEachLack(const Each& each) const;

  const SceneContent* content_;
  const ProbeBinder* shown_;
  const DrawState* state_;
  bool all_ = false, refined_ = false;
  std::vector<Need> needs_;  ///< per probe
  Need sky_;
  std::weak_ptr<const ProbeMaps> alsoOf_;
  LevelMask also_ = 0;
  // No level was missing when these were shown.
  mutable std::uint64_t wholeShown_ = ~std::uint64_t{0};
  mutable const ProbeMaps* wholeSky_ = nullptr;
  mutable bool whole_ = false;
};

class ProbeBinder {
 public:
  /// `with` and everything it points to must outlive this object.
  explicit ProbeBinder(const ProbeContext& with) : with_(with), needs_(with.content, this, with.state.get()) {}

  // What probes are drawn with:
  /// Applies a change of the scene's list of probes.
  void rearrange(const ProbeEntries::Origins& origins);
  /// Applies boxes, weights, techniques and lights of the scene; assign() must follow.
  void updateShapes();
  std::size_t size() const { return probes_.size(); }
  /// Changes whenever other maps may be shown.
  std::uint64_t generation() const { return generation_; }
  const DrawnProbe& drawn(std::size_t index) const { return *probes_[index].drawn; }
  /// Is it one of these, at its index?
  bool has(const DrawnProbe& probe) const;
  /// Draws the probe with these maps from now on; null: it gives no light. Objects get other programs if necessary.
  void show(std::size_t index, std::shared_ptr<const ProbeMaps> maps);
  void showSky(std::shared_ptr<const ProbeMaps> maps);
  /// Adds to new maps the colour of glass, which their coverage lacks.
  void addTint(std::size_t index, const ProbeMaps& maps) const;

  /// Delays the tracing of lamps' visibility while a box is dragged: captures wait for it.
  void holdSight(bool held) { sight_.hold(held); }
  bool sightPending() const { return sight_.pending(); }
  /// See SightWork::bytes().
  std::size_t sightBytes() const { return sight_.bytes(); }
  /// Traces for the probes that the plan requests, and no others; to be called when that may have changed.
  void wantSight();
  /// Starts it, or waits briefly. True if probes see their lamps differently, and assign() must follow. Throws
  /// WorkError.
  bool makeSight();

  // What a capture sees while it is drawn:
  /// Draws every probe with its maps from `maps` until seeAgain(); null: it gives no light.
  void see(const std::function<std::shared_ptr<const ProbeMaps>(std::size_t index)>& maps);
  void seeAgain();
  /// For a capture that must not depend on the sky: wraps `drawing` so that there is no sky.
  std::function<void(bool)> withoutSky(std::function<void(bool)> drawing);

  // Which object is lit by which probe:
  /// Assigns to each object the probes whose influence meets it; during a drag only if programs exist, unless
  /// `anyProgram`.
  void assign(bool anyProgram = false);
  /// The same for one object, with any program.
  void assign(std::size_t object);
  /// The probes whose influence box meets the object's bounds, in order of decreasing importance (equal importance by
  /// name, never by file order), at most ProbeBinding::kMaxProbesPerDraw. `general`: with a program that stays valid
  /// for any box inside the influence.
  std::shared_ptr<const ProbeBinding> bindingOf(const DrawnObject& object, bool general) const;
  /// The mip levels that the objects sample.
  LevelNeeds& needs() { return needs_; }
  const LevelNeeds& needs() const { return needs_; }

  // The errors of the techniques that `auto` chooses from, measured with a probe's own final picture in its own box:
  // once after a bake and after a drag, never during one.
  /// The first probe whose errors were measured with another picture or box.
  std::optional<std::size_t> toMeasure() const;
  /// Objects are assigned again, because their techniques may change.
  void measure(std::size_t index);

  void release();

 private:
  struct Shown {
    std::shared_ptr<DrawnProbe> drawn = std::make_shared<DrawnProbe>();
    /// The maps of the probe and of the sky from which the light through openings was computed.
    std::pair<std::shared_ptr<const ProbeMaps>, std::shared_ptr<const ProbeMaps>> openSkyOf;
    /// The inputs of the probe's measured errors.
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
  /// What first captures have, of whichever probe: one may see any object.
  struct InCaptures {
    bool lamps = false, sights = false;
    std::set<std::size_t> hiddenLights;  ///< not seen from everywhere there
  } inCaptures_;
  std::uint64_t generation_ = 0;
  std::vector<Seen> windowSees_;              ///< saved while a capture sees other maps
  std::shared_ptr<const ProbeMaps> skyKept_;  ///< saved while a capture has no sky
};

}  // namespace boxprobe
