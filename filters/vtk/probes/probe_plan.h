// What has to be made for the probes of a scene, and in which order: lazy, so that a probe no visible object uses is
// not captured, and by key, so that nothing is made twice. Knows maps by their keys alone: neither OpenGL nor VTK.
//
//   ProbeEntries   what each probe shows and should show, by key; whether anything drawn is lit by it
//   BounceKeys     which maps a bounce needs: the keys of one bounce follow from those of the one before
//   ProbePlan      the jobs that follow: the sky; realtime and custom probes (and, during a drag, first bounces) in the
//                  order of the scene's list; maps read from files; then bounces, all first ones before the second ones
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "filters/core/geometry/probe_index.h"
#include "filters/core/scene/scene.h"
#include "filters/io/cube/bake_folder.h"
#include "filters/io/cube/sky_levels.h"
#include "filters/vtk/maps/face_keys.h"
#include "filters/vtk/probes/bake_state.h"
#include "filters/vtk/probes/capture_key.h"
#include "filters/vtk/probes/custom_pictures.h"

namespace boxprobe {

enum class JobKind {
  SkyMap,    ///< the sky's own map, captured
  File,      ///< of a probe or the sky, read from the folder of baked files
  Picture,   ///< filtered from a picture of the user's
  Drag,      ///< a first bounce for the time of a drag
  Bounce,    ///< a bounce of a baked probe
  Realtime,  ///< a further round of a probe that follows what it shows
  Levels,    ///< of the sky, read from the file beside its picture
};

struct ProbeJob {
  JobKind kind = JobKind::Bounce;
  std::string name;  ///< of the probe; empty: the sky
  int bounce = 1;    ///< the first one is 1
  std::string key;   ///< of the maps it makes; empty for Realtime, whose key is known when all faces are
  int faceSize = 0;  ///< texels
  bool operator==(const ProbeJob& o) const { return kind == o.kind && name == o.name && key == o.key; }
};

/// Ends the key of maps that are captured during a drag: they show at once but do not count as the final ones.
constexpr const char* kDuringDrag = " during a drag";

/// Where maps come from besides captures: those that were made before, the folder of baked files, pictures of the
/// user's, the levels that come with a sky's picture.
struct ProbeSources {
  std::function<bool(const std::string& key)> cached;  ///< are the maps of that key at hand?
  BakeFolder folder;
  CustomPictures pictures;
  std::string skyLevels =
      {};  ///< the file beside the sky's picture; empty: the sky is no picture, or the file is damaged

  /// May a job take them instead of making them?
  bool have(const std::string& key) const { return cached(key) || folder.has(key); }
};

struct ProbeEntry {
  std::string name;
  std::string shown;   ///< key of the maps it shows; empty: it shows none
  std::string wanted;  ///< key of those it should show; empty: there is nothing it could show
  FaceKeys faces;      ///< realtime: of the faces it shows
  int passes = 0;      ///< realtime: further rounds until mirrors in mirrors have settled
  bool used = false;   ///< some visible object is lit by it
  bool seen = true;    ///< some object of the last frame is, or there are so few that all are made at once
  bool asked = false;  ///< its maps are wanted, or those of a probe that shows its light, as of the last updateKeys()
  bool again = false;  ///< asked for although nothing changed: no face is kept
  bool fromFile = false;  ///< what it shows was read from a file
  std::string given;      ///< key of maps from elsewhere, shown in place of captures; empty: none
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
  /// The same for a list of which the caller knows where each probe was, whatever its name is now.
  void follow(const Origins& origins);
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

/// Capture n of a probe shows the probes that light what it sees as they were captured at n - 1. So a bounce whose
/// inputs did not change has the key of the one before, and a probe that no bounce of another shows does not make the
/// other stale.
class BounceKeys {
 public:
  struct Input {
    std::string view;  ///< of the capture (or import) itself; empty: nobody asks for this probe
    int bounces = 1;
    bool imported = false;              ///< from a picture: the same at every bounce
    bool lattices = false;              ///< of probes light what its later bounces show
    bool realtime = false;              ///< not in other probes' bounces: it would make them stale at every frame
    std::vector<std::size_t> lighting;  ///< probes that light what the capture shows, as boxes are now
    std::optional<BakeRecord> record;   ///< of maps made from the same view before
  };

  BounceKeys() = default;
  explicit BounceKeys(std::vector<Input> inputs);

  const Input& input(std::size_t probe) const { return inputs_[probe]; }
  /// The key of a probe's maps as of a bounce; 1 is the first. More than its own bounces: the last.
  const std::string& key(std::size_t probe, int bounce) const;
  const std::string& finalKey(std::size_t probe) const { return key(probe, inputs_[probe].bounces); }
  /// The probes per probe's later bounces show: as its record has it, so that maps once made are not undone by a box,
  /// plus those that came since.
  const std::vector<std::size_t>& sees(std::size_t probe) const { return sees_[probe]; }
  /// What to remember with maps that are made now.
  BakeRecord record(std::size_t probe) const;

  /// Adds to `missing` what has to be made before and for a probe's maps of a bounce: those of which `have` says no.
  template <typename Have>
  void collect(std::size_t probe, int bounce, const Have& have,
               std::vector<std::pair<int, std::size_t>>& missing) const {
    if (bounce > inputs_[probe].bounces) bounce = inputs_[probe].bounces;
    const std::pair<int, std::size_t> job{bounce, probe};
    if (have(key(probe, bounce))) return;
    // A bounce that shows nothing new is the one before.
    if (bounce > 1 && key(probe, bounce) == key(probe, bounce - 1)) return collect(probe, bounce - 1, have, missing);
    for (const auto& known : missing) {
      if (known == job) return;
    }
    if (bounce > 1) {
      for (const std::size_t other : sees_[probe]) collect(other, bounce - 1, have, missing);
    }
    missing.push_back(job);
  }

 private:
  std::vector<Input> inputs_;
  std::vector<std::vector<std::size_t>> sees_;
  std::vector<std::vector<std::string>> keys_;  ///< [probe][bounce - 1]
};

/// Whether level 0 of a probe's maps holds its faces as they were captured: the frosty filter blurs it, too.
inline bool keepsCapture(const Probe& probe) {
  return probe.filter == FilterKind::Ggx;
}

class ProbePlan {
 public:
  /// `scene`: the probes as captures take them; must outlive this. `cached`: are the maps of that key at hand?
  ProbePlan(const Scene* scene, std::function<bool(const std::string& key)> cached)
      : entries_(scene), sources_{std::move(cached), {}, {}, {}} {}

  ProbeEntries& entries() { return entries_; }
  const ProbeEntries& entries() const { return entries_; }
  ProbeSources& sources() { return sources_; }
  const ProbeSources& sources() const { return sources_; }

  // Keys. What a probe shows is not even looked for as long as nobody asks.
  /// What captures show from now on; updateKeys() follows.
  void setWorld(CaptureWorld world) { world_ = std::move(world); }
  const CaptureWorld& world() const { return world_; }
  /// Sets what each entry wants, for those that somebody needs.
  void updateKeys();
  /// Of baked and custom probes, as of the last updateKeys().
  const BounceKeys& bounces() const { return bounces_; }
  /// Of one face (0 to 5) of a probe's bounce: equal keys, equal texels of level 0. Empty: it is not to be used again.
  std::string faceKey(std::size_t index, int bounce, int face) const;
  /// Is the first of its captures without the light of the sky, which comes with the lattices of later ones?
  bool firstWithoutSky(std::size_t index) const;
  /// The same of a realtime probe, given as it was when its capture began, and of its maps made of six such faces.
  std::string realtimeFaceKey(const Probe& probe, int face) const;
  static std::string realtimeKey(const Probe& probe, const FaceKeys& faces);
  /// Its final maps are made: remembers what of, so that moving its box does not undo them.
  void remember(std::size_t index);
  /// What is made for it from here on follows the boxes as they are.
  void forget(std::size_t index) { records_.erase(bounces_.input(index).view); }

  // What is to be done at all. Each takes effect with the next make().
  void setEnabled(bool enabled) { enabled_ = enabled; }
  bool enabled() const { return enabled_; }
  /// A handle is held: baked probes are captured for the time being, a single bounce.
  void setInteractive(bool interactive) { interactive_ = interactive; }
  bool interactive() const { return interactive_; }
  /// Names of baked probes that are made whether used or not, and nothing else; empty: whatever is needed.
  void setTargets(std::set<std::string> names) { targets_ = std::move(names); }
  const std::set<std::string>& targets() const { return targets_; }
  /// Key of the sky's own map as it should be. An image is captured finer than a gradient, and no finer than its
  /// columns: a face is a quarter of them. 0: no image.
  void wantSky(std::string key, int imageColumns);
  bool skyIsImage() const { return skyImageColumns_ > 0; }
  void skyShows(std::string key) { skyShown_ = std::move(key); }
  const std::string& skyWanted() const { return skyWanted_; }
  bool skyStale() const { return skyWanted_ != skyShown_; }

  /// Plans again from what entries show and want. The memory is to be checked again.
  void make();
  /// In the order in which they are done. A job leaves the list by the plan that is made when its maps are shown.
  const std::vector<ProbeJob>& jobs() const { return jobs_; }
  /// Does the probe show something else than it should, and is something to be done about that now?
  bool stale(std::size_t index) const;
  void giveUp() { jobs_.clear(); }

  /// The job under way; nothing while none is.
  void begin(const ProbeJob& job) { current_ = job; }
  void end() { current_.reset(); }
  const std::optional<ProbeJob>& current() const { return current_; }
  /// May it go on? A map that follows a drag or something that moves is completed, although the scene has moved on: a
  /// picture a little late is better than none.
  bool keepsCurrent() const;
  /// Is anything planned or under way that will be kept? What a drag captures is replaced at its end.
  bool capturesLast() const;

  /// Are there jobs whose memory nobody has checked?
  bool memoryUnchecked() const { return !memoryChecked_ && !jobs_.empty(); }
  /// Do the maps fit into that many bytes? If not, memoryError() says why not.
  bool checkMemory(std::size_t limitBytes);
  /// One line; empty: they fit, or nobody has asked since make().
  const std::string& memoryError() const { return memoryError_; }

  BakeState state(const std::string& probeName) const;
  /// What the maps a baked probe shows were made from; nothing while they are not the final ones. Empty: the sky.
  std::optional<BakeRecord> record(const std::string& probeName) const;

 private:
  BounceKeys::Input input(std::size_t index) const;
  BounceKeys askedBounces() const;
  void planSky();
  bool bakesAny() const;  ///< of the targets
  void planBounces();
  void planBounce(std::size_t index, int bounce);

  ProbeEntries entries_;
  ProbeSources sources_;
  CaptureWorld world_;
  BounceKeys bounces_;
  std::map<std::string, BakeRecord> records_;  ///< by view
  bool enabled_ = true, interactive_ = false;
  std::set<std::string> targets_;
  std::string skyWanted_, skyShown_;
  int skyImageColumns_ = 0;

  std::vector<ProbeJob> jobs_;
  std::optional<ProbeJob> current_;
  bool memoryChecked_ = false;  ///< since the jobs were planned
  std::string memoryError_;
};

}  // namespace boxprobe
