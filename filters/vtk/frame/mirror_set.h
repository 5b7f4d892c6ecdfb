// The planar mirrors of a scene at work: which have a picture in the frame at hand, which are left out and why, and how
// large each is. A mirror's picture is drawn only if it can show, largest on the screen first, until the frame's texels
// are spent. Owned by the scene renderer, which draws the pictures before each frame and takes them back after it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "filters/core/geometry/mirror_view.h"
#include "filters/vtk/draw/mirror_picture.h"
#include "filters/vtk/frame/mirror_painter.h"

namespace boxprobe {

/// What became of a mirror in the last frame.
enum class MirrorState { NotDrawn, Drawn, Disabled, Rough, FacingAway, NotInView, NothingDynamic, OverBudget };

/// Why it has no picture, as the end of a sentence; empty if it has.
const char* mirrorStateText(MirrorState state);

struct MirrorReport {
  std::string node;
  MirrorState state = MirrorState::NotDrawn;
  int width = 0, height = 0;  ///< texels of the picture
  std::size_t objects = 0;    ///< that move, in it
  std::size_t hiding = 0;     ///< that stand still and may hide them
  MirrorPlane plane;
  glm::dvec3 eye{0.0};  ///< the mirrored one, while Drawn
};

class MirrorSet {
 public:
  MirrorSet(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, const SceneContent* content);

  /// After objects, materials or mirrors of the scene changed: planes are found again, and the objects whose programs
  /// look a picture up are told so.
  void update();
  /// Before a picture of `width` x `height` pixels through `camera` is drawn; the context must be current. `samples`:
  /// those of a texel. Throws WorkError.
  void draw(vtkCamera* camera, double aspect, int width, int height, int samples);
  /// After it.
  void hide();
  /// Reads the shown picture of an object's mirror back, for explanations.
  void readBack();

  const std::vector<MirrorReport>& reports() const { return reports_; }
  std::size_t memoryBytes() const;
  /// Empty, or why a mirror of the scene is none.
  const std::string& problem() const { return problem_; }
  void forgetObjects() { painter_.forgetObjects(); }
  void release();

 private:
  struct Mirror {
    std::string node;
    PlanarMirror settings;
    MirrorPlane plane;
    std::vector<std::size_t> objects;  ///< of the content: more than one where it was divided
    double roughnessMin = 1.0, roughnessMax = 0.0;
    bool bumpy = false;
    bool usable = false;  ///< has a program that looks its picture up
    std::shared_ptr<MirrorPicture> picture = std::make_shared<MirrorPicture>();
    std::unique_ptr<MirrorTarget> target = std::make_unique<MirrorTarget>();
  };
  /// What a frame is going to draw for one mirror.
  struct Plan {
    std::size_t mirror = 0;
    MirrorPlane plane;
    PictureView view;  ///< the mirrored one
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
