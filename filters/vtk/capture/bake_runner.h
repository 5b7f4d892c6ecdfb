// Makes one cubemap step by step, a face or a level at a time, outside the window's renders.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "filters/math/cube/cube_map.h"
#include "filters/vtk/capture/cube_capture.h"
#include "filters/vtk/capture/prefilter.h"
#include "filters/vtk/capture/work_times.h"

namespace boxprobe {

/// The settings of capture and filter in a probe's fields.
CaptureSettings captureSettings(const Probe& probe);
PrefilterSettings prefilterSettings(const Probe& probe);

/// The source of one face.
struct FaceSource {
  std::shared_ptr<const ProbeMaps> same;  ///< maps with an identical face, which is copied instead of drawn
  std::vector<vtkProp*> props;
  std::vector<vtkLight*> lights;
  std::size_t objects = 0;  ///< number of `props` without the sky
  std::size_t culled = 0;   ///< further objects, which are outside the face's view
};

/// A cubemap to make.
struct BakeItem {
  CaptureSettings settings;
  int faceSize = 256;
  int bounce = 1;               ///< of its probe: the bounce that its cost is added to
  bool coarse = false;          ///< shown until other maps are there; nothing is derived from it
  bool sky = false;             ///< the sky's map: at infinity, so without distances
  bool reflectNothing = false;  ///< first bounce: no probe has been captured yet
  /// In a first bounce, use programs without probe lookups. Compiling these pays only for many faces.
  bool firstBouncePrograms = false;
  /// Returns the visibility of lamps from the capture origin, called just before a face is made (PassSettings::sight).
  /// May be null.
  std::function<std::shared_ptr<const ProbeSight>()> sight;
  /// Small levels are filtered together, as one unit that costs less than level 1 alone: fewer steps until a realtime
  /// map is shown.
  bool fewSteps = false;
  PrefilterSettings prefilter;
  /// Returns the levels of a chain that something samples, called when filtering starts; null: all.
  std::function<LevelMask(int levels)> levels;
  std::shared_ptr<const CubeMap> picture;  ///< used in place of a capture; `face` is then not called

  /// Called just before a face is made, so that it shows the current scene.
  std::function<FaceSource(int face)> face;
  /// Called with true before a face is drawn and with false after it: lets it see other probes than the window.
  std::function<void(bool)> drawing;
  /// Called with the finished maps, which nothing sees before.
  std::function<void(std::shared_ptr<const ProbeMaps>)> publish;
};

/// Filters missing levels of a chain later, from its level 0, which is the capture itself. Makes the same texels as
/// filtering at once.
class LevelFilter {
 public:
  /// `prefilter` provides the programs and must outlive this object.
  LevelFilter(vtkOpenGLRenderWindow* window, Prefilter* prefilter);

  /// `chain` holds its unblurred capture in level 0. Makes the window's context current.
  void make(const CubeTexture& chain, LevelMask levels, const PrefilterSettings& settings);
  void release();

 private:
  vtkOpenGLRenderWindow* window_;
  Prefilter* prefilter_;
  CubeTexture source_;
};

class BakeRunner {
 public:
  BakeRunner(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, CubeCapture* capture, Times* times);

  /// Replaces work in progress.
  void start(BakeItem item);
  void abort();
  bool pending() const { return item_ != nullptr; }
  /// Captures at most one face, or filters one level (with fewSteps: the small ones together).
  void step();
  int unitsDone() const { return pending() ? unit_ : 0; }
  static int units(int faceSize, bool fewSteps);
  void release();

 private:
  bool makeFaces();
  void copyFace(const ProbeMaps& from, int face);
  void captureFace(const FaceSource& source, int face);
  bool filter();
  void beginFilter(int levels);
  bool skipped(int level) const { return (maps_->filtered >> level & 1u) == 0; }

  vtkOpenGLRenderWindow* window_;
  std::shared_ptr<DrawState> state_;
  CubeCapture* capture_;
  Times* times_;
  Prefilter prefilter_;
  std::shared_ptr<LevelFilter> later_;  ///< for maps without all levels, as long as the context exists
  CubeTexture source_;
  CubeFramebuffer from_, to_;

  std::unique_ptr<BakeItem> item_;
  std::shared_ptr<ProbeMaps> maps_;
  int face_ = 0;  ///< the next one to make
  int unit_ = 0;
  int level_ = 0;  ///< the next one to filter
};

}  // namespace boxprobe
