// Explains pixels of the current picture: reads the surface from the GPU and the same maps on the CPU, and calls
// explainPixel. Draws twins of the objects with the debug view's programs, so that the picture's programs stay
// unchanged; a twin is made when its object is first under the pointer.
#pragma once

#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <vector>

#include "filters/core/picture/baked_probe.h"
#include "filters/explain/explain_pixel.h"
#include "filters/vtk/inspect/surface_capture.h"
#include "filters/vtk/scene/scene_content.h"

class vtkCamera;

namespace boxprobe {

class SurfaceInspector {
 public:
  SurfaceInspector(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state, SceneContent* content);

  /// One explanation per element of `pixels` (x, y from the top left) of a picture of width x height. The context must
  /// be current. A single pixel draws only that pixel; several draw the picture once.
  std::vector<Explanation> explain(vtkCamera* camera, int width, int height, const std::vector<glm::ivec2>& pixels);

  /// The maps read back, once as long as they live and have no further level filtered; null for null. What the scene's
  /// materials sample is filtered, or is shown so unfiltered, too; nothing is filtered for this. The context must be
  /// current.
  void requireTold(const std::vector<vtkProp*>& props, const std::vector<SurfacePixel>& pixels) const;
  std::shared_ptr<const BakedMaps> onCpu(const std::shared_ptr<const ProbeMaps>& maps);

  /// To be called when the objects were replaced.
  void forgetObjects() { twins_.clear(); }
  void release();

 private:
  bool needsFinish() const;
  vtkProp* twinOf(std::size_t object);
  std::vector<vtkProp*> twinsAt(vtkCamera* camera, double aspect, const glm::dvec2& center, const glm::dvec2& halfSize);
  Explanation explainOne(const SurfacePixel& pixel);
  void readMovingMaps();

  vtkOpenGLRenderWindow* window_;
  std::shared_ptr<DrawState> state_;
  SceneContent* content_;
  SurfaceCapture capture_;
  std::vector<MovingMap> movingMaps_, sunMaps_;  ///< as of the last explanation; a sun's without depths: not drawn
  std::map<std::size_t, vtkSmartPointer<vtkProbeActor>> twins_;
  struct Copy {
    std::weak_ptr<const ProbeMaps> of;
    LevelMask filtered;
    std::shared_ptr<const BakedMaps> maps;
  };
  std::vector<Copy> copies_;  ///< maps read back; dropped when the original is deleted
};

}  // namespace boxprobe
