// Plans which maps of a scene's probes to make, and in which order: lazily, so that a probe that no visible object uses
// is not captured, and by key, so that nothing is made twice. Knows maps only by their keys, without OpenGL and VTK.
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
  Picture,   ///< filtered from a picture file
  Drag,      ///< a first bounce, shown during a drag
  Bounce,    ///< a bounce of a baked probe
  Realtime,  ///< a further round of a realtime probe
  Levels,    ///< of the sky, read from the file beside its picture
  Coarse,    ///< of a probe that has nothing to show yet, in few texels
  Sharp,     ///< of a probe that shows its final maps, in more texels, for mirrors at rest
};

struct ProbeJob {
  JobKind kind = JobKind::Bounce;
  std::string name;  ///< of the probe; empty: the sky
  int bounce = 1;    ///< counted from 1
  std::string key;   ///< of its maps; empty for Realtime, whose key is known after all faces
  int faceSize = 0;  ///< texels
  bool operator==(const ProbeJob& o) const { return kind == o.kind && name == o.name && key == o.key; }
};

/// Suffix of the keys of maps captured during a drag: they are shown at once but are not final.
constexpr const char* kDuringDrag = " during a drag";

/// The same for maps of few texels, shown until a probe's own are there.
constexpr const char* kCoarse = " in few texels";
constexpr int kCoarseFaceSize = 64;

/// The same for maps of more texels than the scene asks for; the number follows.
constexpr const char* kSharp = " in texels: ";

/// Sources of maps besides captures: maps made earlier, the folder of baked files, picture files, the levels beside a
/// sky's picture.
struct ProbeSources {
  std::function<bool(const std::string& key)> cached;  ///< are the maps of that key available?
  BakeFolder folder;
  CustomPictures pictures;
  std::string skyLevels = {};  ///< the file beside the sky's picture; empty: no picture, or a damaged file

  /// Can a job use these maps instead of making them?
  bool have(const std::string& key) const { return cached(key) || folder.has(key); }
};

struct ProbeEntry {
  std::string name;
  std::string shown;      ///< key of the current maps; empty: none
  std::string wanted;     ///< key of the maps it should show; empty: there are none to show
  FaceKeys faces;         ///< realtime: keys of the current faces
  int passes = 0;         ///< realtime: further rounds until mirrors in mirrors have converged
  bool used = false;      ///< some visible object is lit by it
  bool seen = true;       ///< it lights an object of the last frame, or there are few enough probes to make all
  bool asked = false;     ///< the last updateKeys() found its maps, or its light in another's maps, necessary
  bool again = false;     ///< requested although nothing has changed: no face is reused
  bool fromFile = false;  ///< the current maps were read from a file
  std::string given;      ///< key of maps set from outside in place of captures; empty: none
  bool needed() const { return (used && seen) || again; }
};

/// How one object is drawn.
struct ObjectUse {
  bool lit = false;                 ///< visible, with a material that is lit
  std::vector<std::size_t> probes;  ///< that light it, as indices into scene.probes
};

class ProbeEntries {
 public:
  /// The previous index of each probe in the list; nothing for a new one.
  using Origins = std::vector<std::optional<std::size_t>>;

  /// `scene` must outlive this object.
  explicit ProbeEntries(const Scene* scene) : scene_(scene) {}

  /// Matches scene.probes by name: a probe keeps its entry when the list changes; a renamed one is new, and finds its
  /// maps by key. Returns nothing if the names are unchanged.
  std::optional<Origins> match();
  /// The same if the caller knows the origin of each probe, whatever its name.
  void follow(const Origins& origins);
  /// Are the names those of the last match?
  bool matched() const;

  std::size_t size() const { return entries_.size(); }
  ProbeEntry& operator[](std::size_t index) { return entries_[index]; }
  const ProbeEntry& operator[](std::size_t index) const { return entries_[index]; }
  const Scene& scene() const { return *scene_; }
  const Probe& probe(std::size_t index) const { return scene_->probes[index]; }
  bool baked(std::size_t index) const { return probe(index).mode == ProbeMode::Baked; }
  std::optional<std::size_t> find(const std::string& name) const;
  /// The index of the influence boxes, as of the last match().
  const ProbeIndex& places() const { return places_; }

  /// How all objects are drawn, in the scene's order: a probe that reaches an object but was left out of its draw does
  /// not light it.
  void setUse(std::vector<ObjectUse> objects);
  /// Indices of the objects in the last frame; nothing: unknown, as if all were. If there are many probes, only those
  /// that light one of these count as seen. Returns whether that changed for a probe.
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

/// Capture n of a probe shows the light of other probes as captured at n - 1, by their boxes and techniques. So a
/// bounce with unchanged inputs has the key of the previous one, and a probe that is not in any bounce of another does
/// not make it stale.
class BounceKeys {
 public:
  struct Input {
    std::string view;  ///< of the capture (or import) itself; empty: the probe is not requested
    int bounces = 1;
    bool imported = false;              ///< from a picture: the same at every bounce
    bool lattices = false;              ///< later bounces use lattices for diffuse light
    bool latticeSky = false;            ///< which bring the light of the sky: a first bounce of several has none of it
    bool several = false;               ///< other bounces follow the first, in this run or another
    std::string drawn;                  ///< drawnKey(), where later bounces follow it
    bool realtime = false;              ///< not in other probes' bounces, which it would make stale in every frame
    std::vector<std::size_t> lighting;  ///< probes that light what the capture shows, by the current boxes
    std::optional<BakeRecord> record;   ///< of maps made earlier from the same view, where these do not follow
  };

  BounceKeys() = default;
  explicit BounceKeys(std::vector<Input> inputs);

  const Input& input(std::size_t probe) const { return inputs_[probe]; }
  /// The key of a probe's maps for a bounce, from 1; beyond its own bounces that of the last.
  const std::string& key(std::size_t probe, int bounce) const;
  const std::string& finalKey(std::size_t probe) const { return key(probe, inputs_[probe].bounces); }
  /// The probes that each probe's later bounces show: by the current boxes; if it has a record, those of the record,
  /// plus new ones.
  const std::vector<std::size_t>& sees(std::size_t probe) const { return sees_[probe]; }
  /// The record to store with new maps.
  BakeRecord record(std::size_t probe) const;

  /// Adds to `missing` the bounces, in order, that are needed for a probe's maps of a bounce and for which `have` is
  /// false.
  template <typename Have>
  void collect(std::size_t probe, int bounce, const Have& have,
               std::vector<std::pair<int, std::size_t>>& missing) const {
    if (bounce > inputs_[probe].bounces) bounce = inputs_[probe].bounces;
    const std::pair<int, std::size_t> job{bounce, probe};
    if (have(key(probe, bounce))) return;
    // A bounce that shows nothing new equals the previous one.
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

/// Does level 0 of a probe's maps hold its faces as captured? The Gaussian filter also blurs level 0.
inline bool keepsCapture(const Probe& probe) {
  return probe.filter == FilterKind::Ggx;
}

class ProbePlan {
 public:
  /// `scene`: the probes for captures; must outlive this object. `cached`: are the maps of that key available?
  ProbePlan(const Scene* scene, std::function<bool(const std::string& key)> cached)
      : entries_(scene), sources_{std::move(cached), {}, {}, {}} {}

  ProbeEntries& entries() { return entries_; }
  const ProbeEntries& entries() const { return entries_; }
  ProbeSources& sources() { return sources_; }
  const ProbeSources& sources() const { return sources_; }

  // Keys. What a probe shows is only determined if it is requested.
  /// Sets what captures show; updateKeys() must follow. During a drag who lights what stays as it was.
  void setWorld(CaptureWorld world);
  const CaptureWorld& world() const { return world_; }
  /// Sets the wanted keys of entries that are needed.
  void updateKeys();
  /// Of baked and custom probes, as of the last updateKeys().
  const BounceKeys& bounces() const { return bounces_; }
  /// For one face (0 to 5) of a probe's bounce: equal keys mean equal texels of level 0. Empty: must not be reused.
  std::string faceKey(std::size_t index, int bounce, int face) const;
  /// Is the first of its captures without the light of the sky, which comes with the lattices of later ones?
  bool firstWithoutSky(std::size_t index) const;
  /// The same for a realtime probe, given as it was when its capture started, and for its maps of six such faces.
  std::string realtimeFaceKey(const Probe& probe, int face) const;
  static std::string realtimeKey(const Probe& probe, const FaceKeys& faces);
  /// To be called when its final maps were made: records their inputs, so that moving its box does not invalidate them.
  void remember(std::size_t index);
  /// New maps of it follow the current boxes.
  void forget(std::size_t index) { records_.erase(bounces_.input(index).view); }

  /// Are later bounces stale when a box or technique is another? Not where nobody tells when a drag ends.
  void setFollowsBoxes(bool follows) { followsBoxes_ = follows; }

  // Options that take effect with the next make().
  void setEnabled(bool enabled) { enabled_ = enabled; }
  bool enabled() const { return enabled_; }
  /// During a drag: baked probes are captured temporarily, with a single bounce.
  /// Their later bounces do not follow boxes and techniques until its end, when setWorld() must follow.
  void setInteractive(bool interactive) { interactive_ = interactive; }
  bool interactive() const { return interactive_; }
  /// Probes with nothing to show yet are captured in few texels before anything else.
  void setCoarseFirst(bool coarse) { coarseFirst_ = coarse; }
  /// Are they now? Not for files, and not beside realtime probes, whose captures see whatever is shown.
  bool coarseFirst() const;
  /// Is such a capture planned or in progress?
  bool coarsePending() const;
  /// Baked probes, by name, whose final maps are made again with faces of so many texels. Others show maps of their own
  /// size again.
  const std::map<std::string, int>& sharp() const { return sharp_; }
  void setSharp(std::map<std::string, int> faceSizes) { sharp_ = std::move(faceSizes); }
  /// Does it show its final maps in more texels, as asked?
  bool showsSharp(std::size_t index) const;
  /// Names of baked probes to make, used or not, and nothing else; empty: whatever is needed.
  void setTargets(std::set<std::string> names) { targets_ = std::move(names); }
  /// Probes whose later bounces another run makes: CaptureWorld::cutShort.
  void setCutShort(std::set<std::string> names) { world_.cutShort = std::move(names); }
  const std::set<std::string>& targets() const { return targets_; }
  /// The key that the sky's map should have. An image is captured with more texels than a gradient, at most a quarter
  /// of its columns per face. 0: no image.
  void wantSky(std::string key, int imageColumns);
  bool skyIsImage() const { return skyImageColumns_ > 0; }
  void skyShows(std::string key) { skyShown_ = std::move(key); }
  const std::string& skyWanted() const { return skyWanted_; }
  bool skyStale() const { return skyWanted_ != skyShown_; }

  /// Plans again from the entries' current and wanted keys. Memory must be checked again.
  void make();
  /// In order of execution. A job is removed by the plan made when its maps are shown.
  const std::vector<ProbeJob>& jobs() const { return jobs_; }
  /// Does the probe show something else than it should, with work planned for it?
  bool stale(std::size_t index) const;
  void cancelWork() { jobs_.clear(); }

  /// The current job; nothing between jobs.
  void begin(const ProbeJob& job) { current_ = job; }
  void end() { current_.reset(); }
  const std::optional<ProbeJob>& current() const { return current_; }
  /// May it continue? A map for a drag or of a realtime probe is completed although the scene has changed: a late
  /// picture is better than none.
  bool keepsCurrent() const;
  /// Is anything planned or in progress that will be kept? Maps captured for a drag are replaced at its end.
  bool capturesLast() const;

  /// Are there jobs whose memory has not been checked?
  bool memoryUnchecked() const { return !memoryChecked_ && !jobs_.empty(); }
  /// Do the maps and lattices fit into that many bytes? If not, memoryError() gives the reason. `visibilityBytes`: of
  /// the lattices of what is seen of lamps.
  bool checkMemory(std::size_t limitBytes, std::size_t visibilityBytes = 0);
  /// One line; empty: they fit, or were not checked since make().
  const std::string& memoryError() const { return memoryError_; }

  BakeState state(const std::string& probeName) const;
  /// The inputs of a baked probe's maps; nothing unless they are final. Empty name: the sky.
  std::optional<BakeRecord> record(const std::string& probeName) const;

 private:
  BounceKeys::Input input(std::size_t index) const;
  BounceKeys askedBounces() const;
  void updateDrawn();
  void planCoarse();
  void planSky();
  bool bakesAny() const;  ///< among the targets
  void planBounces();
  void planBounce(std::size_t index, int bounce);
  void planSharp();

  ProbeEntries entries_;
  ProbeSources sources_;
  CaptureWorld world_;
  BounceKeys bounces_;
  std::map<std::string, BakeRecord> records_;  ///< by view
  std::map<std::string, std::string> drawn_;   ///< drawnKey() by name, as before a drag
  bool followsBoxes_ = true;
  std::size_t worldProbes_ = 0;  ///< probes in the list when the world was set
  bool enabled_ = true, interactive_ = false, coarseFirst_ = false;
  std::set<std::string> targets_;
  std::map<std::string, int> sharp_;
  std::string skyWanted_, skyShown_;
  int skyImageColumns_ = 0;

  std::vector<ProbeJob> jobs_;
  std::optional<ProbeJob> current_;
  bool memoryChecked_ = false;  ///< since the jobs were planned
  std::string memoryError_;
};

}  // namespace boxprobe
