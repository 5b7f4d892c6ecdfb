// Controls pictures that average frames or smooth reflections: decides whether a frame continues the previous picture
// or starts a new one, so that no earlier state remains visible. Uses no GPU resources until a technique needs it.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "filters/vtk/frame/frame_count.h"
#include "filters/vtk/frame/refinement.h"
#include "filters/vtk/frame/vtkPicturePass.h"
#include "filters/vtk/scene/scene_content.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

class PictureFrames {
 public:
  PictureFrames(vtkOpenGLRenderWindow* window, vtkCulledRenderer* renderer, std::shared_ptr<DrawState> state,
                const SceneContent* content);
  /// For a renderer of another program, whose window is set later. `props`: those that make the picture; all others
  /// are drawn over it. The renderer has a pass only between beginFrame() and endFrame().
  PictureFrames(vtkRenderer* renderer, std::shared_ptr<DrawState> state, const SceneContent* content,
                std::function<std::vector<vtkProp*>()> props);
  void setWindow(vtkOpenGLRenderWindow* window) { window_ = window; }

  /// The scene differs from that of the previous frame.
  void sceneChanged() { ++generation_; }
  /// To be called before each frame of the window, with the surfaces as they will be drawn. `plain`: no surface shows a
  /// technique's picture (a debug view). `hold`: captures are pending, and refinement waits for them.
  void beginFrame(bool plain, bool hold);
  /// Takes the pass off another program's renderer.
  void endFrame();
  /// Does a technique that is drawn average frames?
  bool averages() const { return raysAFrame() > 0; }
  FrameCount count() const;
  /// Overrides the number of frames that follows from the techniques' rays.
  void setLimit(std::optional<int> frames) { limit_ = frames; }
  /// Starts refinement with the next frame, as long as nothing changes (refinement.h).
  void refine(const RefineSettings& settings);
  const RefineSettings& refineSettings() const { return settings_; }
  /// The progress of the window's picture, or of the last linear one.
  const Refinement& refinement() const { return stages_; }
  /// The next draws use the techniques; a refined picture continues with its next frame.
  void dropRays();
  /// For a refined linear picture; null if the plain way draws the same. Must be returned after drawing.
  vtkPicturePass* refinedPass(const RefineSettings& settings);
  /// For a linear picture of `frames` frames; null if the plain way draws the same. Must be returned after drawing.
  vtkPicturePass* linearPass(int frames);
  void releaseLinear();
  void release();

 private:
  /// What a frame shows: equal keys mean equal pictures, except for the pattern of the rays.
  struct Key {
    int generation = 0;
    std::array<double, 14> camera{};
    std::array<int, 5> size{};                                ///< width, height, samples, lower left corner
    std::vector<std::weak_ptr<const ProbeBinding>> bindings;  ///< as drawn
    std::vector<std::weak_ptr<const ProbeMaps>> maps;
    std::vector<std::weak_ptr<const DiffuseLattice>> lattices;
    bool operator==(const Key& o) const;
  };
  Key key() const;
  const ProbeBinding* drawn(const DrawnObject& object) const;
  int raysAFrame() const;
  int blurredRays() const;
  bool looksBehind() const;
  int wanted() const;
  vtkSmartPointer<vtkPicturePass> makePass() const;
  void setRays(RefinedRays rays);
  /// The number of rays that the techniques' own frame is worth; 0: there is nothing to refine.
  int firstGuess() const;
  void beginRefinement(vtkPicturePass* pass, const RefineSettings& settings);
  bool advance(vtkPicturePass* pass, bool hold);
  bool outOfTime() const;
  void show(int rays, bool behind);

  vtkOpenGLRenderWindow* window_;
  vtkRenderer* renderer_;
  std::shared_ptr<DrawState> state_;
  const SceneContent* content_;
  std::function<std::vector<vtkProp*>()> props_;
  vtkProp* sky_ = nullptr;  ///< null: what is behind the picture belongs to another program
  vtkSmartPointer<vtkPicturePass> screen_, linear_;
  bool active_ = false, plain_ = false;
  int generation_ = 0;
  std::optional<int> limit_;
  RefineSettings settings_;  ///< of the window's picture
  Refinement stages_;
  bool refining_ = false;  ///< refines the window's current picture
  bool tried_ = false;     ///< checked whether there is anything to refine
  bool guessing_ = false;  ///< the current frame is the technique's own
  bool stopped_ = false;   ///< out of time: shows what it has reached
  std::chrono::steady_clock::time_point begun_;
  Key shown_;
};

}  // namespace boxprobe
