// Chooses which planar mirrors of a scene have a picture in the current frame, and its size; others are skipped for a
// recorded reason. A picture is drawn only if it would be visible, the largest on screen first, until the frame's
// texels are used up. Pictures are drawn before each frame and withdrawn after it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "filters/core/base/phrase.h"
#include "filters/core/geometry/mirror_view.h"
#include "filters/vtk/draw/mirror_picture.h"
#include "filters/vtk/frame/mirror_painter.h"

namespace boxprobe {

/// The state of a mirror in the last frame.
enum class MirrorState { NotDrawn, Drawn, Disabled, Rough, FacingAway, NotInView, NothingDynamic, OverBudget };

/// Why it has no picture, as the end of a sentence; empty if it has one.
Phrase mirrorStateText(MirrorState state);

struct MirrorReport {
  std::string node;
  MirrorState state = MirrorState::NotDrawn;
  int width = 0, height = 0;  ///< texels of the picture
  std::size_t objects = 0;    ///< moving objects in it
  std::size_t hiding = 0;     ///< static objects that may hide them
  MirrorPlane plane;
  glm::dvec3 eye{0.0};  ///< mirrored eye, if Drawn
};

class MirrorSet {
 public:
  MirrorSet(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, const SceneContent* content);

  /// To be called when objects, materials or mirrors have changed: finds planes, and marks the objects whose programs
  /// sample a picture.
  void update();
  /// To be called before a picture of `width` x `height` pixels with `camera` is drawn; the context must be current.
  /// `samples`: per texel. Throws WorkError.
  void draw(vtkCamera* camera, double aspect, int width, int height, int samples);
  /// To be called after it.
  void hide();
  /// Reads back the current picture of an object's mirror, for explanations.
  void readBack();

  const std::vector<MirrorReport>& reports() const { return reports_; }
  std::size_t memoryBytes() const;
  /// Empty, or why a mirror of the scene is invalid.
  const std::string& problem() const { return problem_; }
  void forgetObjects() { painter_.forgetObjects(); }
  void release();

 private:
  struct Mirror {
    std::string node;
    PlanarMirror settings;
    MirrorPlane plane;
    std::vector<std::size_t> objects;  ///< indices in the content: several for a divided object
    double roughnessMin = 1.0, roughnessMax = 0.0;
    bool bumpy = false;
    bool usable = false;  ///< has a program that samples its picture
    std::shared_ptr<MirrorPicture> picture = std::make_shared<MirrorPicture>();
    std::unique_ptr<MirrorTarget> target = std::make_unique<MirrorTarget>();
  };
  /// What a frame will draw for one mirror.
  struct Plan {
    std::size_t mirror = 0;
    MirrorPlane plane;
    PictureView view;  ///< the mirrored view
    double area = 0.0, farHeight = 0.0, resolution = 1.0;
    std::vector<std::size_t> moving, hiding;
  };
  MirrorState plan(std::size_t index, const PictureView& view, const std::vector<std::size_t>& dynamic, Plan& plan);
  void findHiding(Plan& plan, const std::vector<std::size_t>& own);
  void paint(const Plan& plan, const PictureView& view, int samples);
  std::vector<std::size_t> dynamicObjects() const;
  void count(MirrorState state);

  vtkOpenGLRenderWindow* window_;
  std::shared_ptr<DrawState> state_;
  const SceneContent* content_;
  MirrorPainter painter_;
  std::vector<Mirror> mirrors_;
  std::vector<MirrorReport> reports_;
  std::string problem_;
};

}  // namespace boxprobe
