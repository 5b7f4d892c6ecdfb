// Pictures that are means of frames, or whose reflections are smoothed: says when a frame continues the picture before
// it and when it begins another, so that nothing of an earlier moment is ever left in it. Owned by the scene renderer;
// while no technique asks for it, nothing of it exists on the graphics side.
#pragma once

#include <vtkSmartPointer.h>

#include <array>
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

  /// The scene is another one than in the frame before.
  void sceneChanged() { ++generation_; }
  /// Before each frame of the window, whose surfaces are then as they will be drawn. `plain`: no surface shows a
  /// picture of a technique (a debug view). `hold`: captures come first, a refinement waits for them.
  void beginFrame(bool plain, bool hold);
  /// Does a technique that is drawn ask for a mean of frames?
  bool averages() const { return raysAFrame() > 0; }
  FrameCount count() const;
  /// In place of what the techniques' numbers of rays ask for.
  void setLimit(std::optional<int> frames) { limit_ = frames; }
  /// Frames go on to the truth from the next one on, as long as nothing changes (refinement.h).
  void refine(const RefineSettings& settings);
  const RefineSettings& refineSettings() const { return settings_; }
  /// What the window's picture, or the last linear one, has come to.
  const Refinement& refinement() const { return stages_; }
  /// Whatever draws next draws by the techniques; a refined picture goes on with its next frame.
  void dropRays();
  /// For a linear picture that is refined; null if the plain way draws the same. To be given back when it is drawn.
  vtkPicturePass* refinedPass(const RefineSettings& settings);
  /// For a linear picture of `frames` frames; null if the plain way draws the same. To be given back when it is drawn.
  vtkPicturePass* linearPass(int frames);
  void releaseLinear();
  void release();

 private:
  /// What a frame shows: equal keys, equal pictures but for the pattern of the rays.
  struct Key {
    int generation = 0;
    std::array<double, 12> camera{};
    std::array<int, 3> size{};
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
  /// Rays that the techniques' own frame is worth; 0: there is nothing to refine.
  int firstGuess() const;
  void beginRefinement(vtkPicturePass* pass, const RefineSettings& settings);
  bool advance(vtkPicturePass* pass, bool hold);
  void show(int rays, bool behind);

  vtkOpenGLRenderWindow* window_;
  vtkCulledRenderer* renderer_;
  std::shared_ptr<DrawState> state_;
  const SceneContent* content_;
  vtkSmartPointer<vtkPicturePass> screen_, linear_;
  bool active_ = false, plain_ = false;
  int generation_ = 0;
  std::optional<int> limit_;
  RefineSettings settings_;  ///< of the window's picture
  Refinement stages_;
  bool refining_ = false;  ///< the window's picture, since it is as it is
  bool tried_ = false;     ///< whether there is anything to refine was asked for what is shown
  bool guessing_ = false;  ///< the frame is the technique's own
  Key shown_;
};

}  // namespace boxprobe
