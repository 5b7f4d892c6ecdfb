// Makes one cubemap step by step: a face, a level at a time. Knows no scene: it is handed what to capture and whom
// to tell. Called by the probe set outside of the window's renders.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "filters/math/cube/cube_map.h"
#include "filters/vtk/capture/cube_capture.h"
#include "filters/vtk/capture/level_filter.h"
#include "filters/vtk/capture/prefilter.h"
#include "filters/vtk/capture/work_times.h"

namespace boxprobe {

/// What a probe's own fields say of its capture and its filter.
CaptureSettings captureSettings(const Probe& probe);
PrefilterSettings prefilterSettings(const Probe& probe);

/// Where one face comes from.
struct FaceSource {
  std::shared_ptr<const ProbeMaps> same;  ///< already holds this very face: it is copied, nothing is drawn
  std::vector<vtkProp*> props;
  std::vector<vtkLight*> lights;
  std::size_t objects = 0;  ///< of `props`, the sky apart
  std::size_t culled = 0;   ///< further ones, which the face does not show
};

/// One cubemap to make.
struct BakeItem {
  CaptureSettings settings;
  int faceSize = 256;
  int bounce = 1;               ///< of its probe: what its cost is booked under
  bool coarse = false;          ///< seen until others are there, and nothing is derived from it
  bool sky = false;             ///< the sky's own map: at infinity, so without distances
  bool reflectNothing = false;  ///< first bounce: no probe has been captured yet
  /// Then by programs without any lookup of a probe. They have to be compiled, which pays for many faces only.
  bool firstBouncePrograms = false;
  /// What is seen of lamps from the capture origin, asked just before a face is made (PassSettings::sight). May be
  /// null.
  std::function<std::shared_ptr<const ProbeSight>()> sight;
  /// Small levels are filtered together, as one unit that costs less than the first level alone: fewer steps to wait
  /// for a map that follows something that moves.
  bool fewSteps = false;
  PrefilterSettings prefilter;
  /// Which levels of a chain of so many something samples, asked when the filtering begins; null: all.
  std::function<LevelMask(int levels)> levels;
  std::shared_ptr<const CubeMap> picture;  ///< taken in place of a capture; then `face` is not asked

  /// Asked just before a face is made, so that it shows the scene as it is by then.
  std::function<FaceSource(int face)> face;
  /// Called with true before a face is drawn and with false after it: lets it see probes other than the window shows.
  std::function<void(bool)> drawing;
  /// The finished maps. Until then nothing of them can be seen.
  std::function<void(std::shared_ptr<const ProbeMaps>)> publish;
};

class BakeRunner {
 public:
  BakeRunner(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, CubeCapture* capture, Times* times);

  /// Replaces what is under way.
  void start(BakeItem item);
  void abort();
  bool pending() const { return item_ != nullptr; }
  /// At most one face is captured, or one level filtered (with fewSteps: the small ones together).
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
  std::shared_ptr<LevelFilter> later_;  ///< of maps without all levels, as long as there is a context
  CubeTexture source_;
  CubeFramebuffer from_, to_;

  std::unique_ptr<BakeItem> item_;
  std::shared_ptr<ProbeMaps> maps_;
  int face_ = 0;  ///< the next one to make
  int unit_ = 0;
  int level_ = 0;  ///< the next one to filter
};

}  // namespace boxprobe
