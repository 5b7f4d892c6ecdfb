// The probes of a scene at work: which maps each one shows, which are stale, what has to be made for them and in which
// order, and which object uses which probe. Lazy: a probe no visible object uses is not captured. Owned by the scene
// renderer.
//
// A baked probe is made once for given inputs (capture_key.h, bounce_keys.h), kept for undo, and taken from a file
// where one with the same key lies. A realtime probe follows what it shows: one face a step, only faces that changed,
// and the new maps replace the old ones whole, so that no half of one moment is seen beside half of another. A custom
// probe is filtered from a picture.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "filters/io/cube/bake_folder.h"
#include "filters/vtk/capture/bake_runner.h"
#include "filters/vtk/maps/map_cache.h"
#include "filters/vtk/probes/bake_state.h"
#include "filters/vtk/probes/bounce_keys.h"
#include "filters/vtk/probes/capture_key.h"
#include "filters/vtk/probes/custom_pictures.h"
#include "filters/vtk/scene/scene_content.h"

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
  /// The camera or a handle may be moved with cheaper techniques on the screen: their programs are compiled ahead, too.
  void allowStandIns(bool allowed);
  /// Draws by them, as far as they are compiled and unless a capture that lasts is under way, which must not see them.
  /// Returns whether any object is.
  bool setMoving(bool moving);
  /// See the scene renderer's functions of these names.
  void setBakeTargets(const std::vector<std::string>& names);
  void useBakedFiles(const std::string& folder);
  void requestBake(const std::vector<std::string>& names);
  BakeState bakeState(const std::string& probeName) const;
  const std::string& pictureError() const { return pictures_.error(); }
  std::vector<std::string> pictureRemarks() const { return pictures_.remarks(); }
  /// Empty, or why nothing is made: the maps would not fit into the graphics memory.
  const std::string& memoryError() const { return memoryError_; }
  /// Drops all work until something changes.
  void giveUp();
  /// What the maps a baked probe shows were made from; nothing while they are not the final ones. Empty: the sky.
  std::optional<BakeRecord> record(const std::string& probeName) const;

  /// What a frame showed, as indices of objects: of many probes only those are made that something in it is lit by.
  /// Nothing: not known, as if all were.
  void setSeen(std::optional<std::vector<std::size_t>> objects);
  /// Does what is made follow from what frames show?
  bool followsSeen() const { return enabled_ && targets_.empty(); }

  bool workPending() const {
    return runner_.pending() || !jobs_.empty() || toMeasure().has_value() || preparationPending();
  }
  void step();
  double progress() const;

  /// What a probe shows now; null while it has none, or if there is no such probe.
  std::shared_ptr<const ProbeMaps> maps(const std::string& probeName) const;

  std::shared_ptr<const ProbeMaps> maps(std::size_t index) const { return entries_[index].drawn->maps; }

  std::size_t memoryBytes() const;
  void release();

 private:
  /// What a probe's errors were measured with.
  struct Measured {
    std::string shown;
    glm::vec3 boxMin{0.0f}, boxMax{0.0f};
    glm::dmat3 mapFromProbe{1.0};
  };
  struct Entry {
    std::string name;
    std::shared_ptr<DrawnProbe> drawn = std::make_shared<DrawnProbe>();
    std::string shown;      ///< key of the maps it shows
    std::string wanted;     ///< key of those it should; empty: there is nothing it could show
    FaceKeys faces;         ///< realtime: of the faces it shows
    int passes = 0;         ///< realtime: further rounds until mirrors in mirrors have settled
    bool used = false;      ///< some visible object is lit by it
    bool seen = true;       ///< some object of the last frame is, or there are so few that all are made at once
    bool again = false;     ///< asked for although nothing changed: no face is kept
    bool fromFile = false;  ///< what it shows was read from a file
    Measured measured;
    /// What its light of the sky through its openings was worked out from.
    std::pair<std::shared_ptr<const ProbeMaps>, std::shared_ptr<const ProbeMaps>> openSkyOf;
  };
  enum class JobKind { SkyMap, File, Picture, Drag, Bounce, Realtime };
  struct Job {
    JobKind kind;
    std::string name;  ///< of the probe; empty: the sky
    int bounce = 1;
    std::string key;
    int faceSize = 0;
    bool operator==(const Job& o) const { return kind == o.kind && name == o.name && key == o.key; }
  };

  bool needed(std::size_t index) const {
    return (entries_[index].used && entries_[index].seen) || entries_[index].again;
  }
  void findUsed();
  bool findSeen();
  void matchEntries();
  void assign(bool newProgramsAllowed);
  bool preparationPending() const { return !interactive_ && !moving_ && !toPrepare_.empty(); }
  void prepare(std::size_t object, std::shared_ptr<const ProbeBinding> binding);
  void prepareOne();
  bool errorsStale(std::size_t index) const;
  std::optional<std::size_t> toMeasure() const;
  void measureErrors(std::size_t index);
  void updateStandIns();
  /// Returns whether a probe begins or ceases to let the sky through: another program.
  bool updateOpenings();
  void showOpenings();
  void updateShadowLights();
  /// Adds to maps that are new what their coverage does not tell.
  void addTint(std::size_t index, const ProbeMaps& maps) const;
  /// For a capture that must not change with the sky.
  std::function<void(bool)> withoutSky(std::function<void(bool)> drawing);
  bool capturesLast() const;

  std::optional<std::size_t> find(const std::string& name) const;
  const Probe& probe(std::size_t index) const { return content_->scene.probes[index]; }
  static ProbeGeometry geometryOf(const Probe& probe, const ProbeMaps* maps);
  bool baked(std::size_t index) const { return probe(index).mode == ProbeMode::Baked; }
  bool stale(std::size_t index) const;
  void updateWorld();
  void updateKeys();
  void showCached();
  BounceKeys::Input bounceInput(const Probe& probe) const;
  BounceKeys bounceKeys() const;
  std::string realtimeKey(const Probe& probe, const FaceKeys& faces) const;
  std::string realtimeFace(const Probe& probe, int face) const;
  FaceKeys realtimeFaces(const Probe& probe) const;

  void replan();
  void planBounces();
  std::string memoryProblem() const;
  bool keepsCurrent() const;
  void begin(const Job& job);
  void loadFile(const Job& job);
  BakeItem skyItem(const Job& job);
  BakeItem pictureItem(const Job& job);
  BakeItem captureItem(const Job& job);
  BakeItem realtimeItem(const Job& job);
  std::string faceKey(std::size_t index, int bounce, int face) const;
  FaceSource faceSource(const Probe& probe, int face) const;
  void seeBounce(std::size_t of, int bounce);
  void seeAgain();
  void finish(const Job& job, FaceKeys faces, std::shared_ptr<const ProbeMaps> maps, bool fromFile);
  void finishRealtime(const Job& job, const Probe& as, const FaceKeys& faces, std::shared_ptr<const ProbeMaps> maps);
  void show(std::size_t index, const std::string& key, std::shared_ptr<const ProbeMaps> maps);

  std::shared_ptr<DrawState> state_;
  SceneContent* content_;
  CubeCapture* capture_;
  BakeRunner runner_;
  bool enabled_ = true;
  bool interactive_ = false;
  bool editable_ = false;
  bool standInsAllowed_ = false;
  bool moving_ = false;
  std::set<std::string> targets_;

  std::vector<Entry> entries_;  ///< in the order of scene.probes
  std::string skyWanted_, skyShown_;
  std::shared_ptr<const ProbeMaps> skyKept_;  ///< what draws see, while a capture goes without
  std::vector<std::string> contentKeys_;      ///< of the objects
  int contentGeneration_ = -1;
  std::weak_ptr<const ImageRgbaF> skyImage_;
  std::string skyPixels_;
  ProbeIndex index_;
  std::optional<std::vector<std::size_t>> seenObjects_;
  CaptureWorld world_;
  BounceKeys keys_;
  std::map<std::string, BakeRecord> records_;  ///< by view
  CustomPictures pictures_;
  BakeFolder folder_;
  MapCache cache_;

  std::vector<Job> jobs_;
  bool memoryChecked_ = false;  ///< since the jobs were planned
  std::string memoryError_;
  std::optional<Job> current_;                          ///< what the runner is at
  std::vector<std::shared_ptr<const ProbeMaps>> kept_;  ///< of earlier bounces, while later ones are to be made
  int unitsDone_ = 0;

  struct Seen {
    std::shared_ptr<const ProbeMaps> maps;
    ProbeGeometry geometry;
  };
  std::vector<Seen> windowSees_;  ///< what draws see, put aside while a capture sees an earlier bounce

  std::set<std::string> variantsUsed_;  ///< program variants objects have had so far
  std::vector<std::pair<std::size_t, std::shared_ptr<const ProbeBinding>>>
      toPrepare_;  ///< object, its binding in a drag or while the camera moves
  std::set<std::string> prepared_;
};

}  // namespace boxprobe
