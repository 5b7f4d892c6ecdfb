// What every draw of a renderer needs to know: shared by the renderer, its passes and the passes of its actors. Parts
// that live differently long: what there is (resources), how a pass draws (pass), what was drawn (counts), what is done
// for the driver's sake (tuning), and the draw under way (drawing, bound).
#pragma once

#include <vtkWeakPointer.h>

#include <memory>
#include <vector>

#include "filters/vtk/draw/frame_counts.h"
#include "filters/vtk/draw/pass_settings.h"
#include "filters/vtk/draw/scene_resources.h"
#include "filters/vtk/gl/gl_objects.h"

class vtkRenderer;

namespace boxprobe {

class ProgramTuning;

/// One for all surfaces of a renderer.
class DrawState {
 public:
  SceneResources resources;
  FrameCounts counts;
  ProgramTuning* tuning = nullptr;  ///< null: none (program_tuning.h)
  /// Draws the window's picture: its camera's lights are uploaded again after a pass with another camera (PassScope).
  vtkWeakPointer<vtkRenderer> shown;
  /// What draws now; its camera is what uniforms go by. Null: nothing of ours, and surfaces have VTK's own programs.
  vtkRenderer* drawing = nullptr;
  std::vector<std::unique_ptr<BoundTexture>> bound;  ///< for the piece drawn last

  const PassSettings& pass() const { return pass_; }

  /// What the window's own frames are drawn with, until it is set again. Not to be called while a PassScope lasts,
  /// whose end would undo it.
  void setExposure(float exposure) { exposure_ = pass_.exposure = exposure; }
  /// The same within a PassScope.
  float exposure() const { return exposure_; }
  void setDragging(bool dragging) { pass_.dragging = dragging; }
  void setDebugView(const DebugView& debug) { pass_.debug = debug; }

 private:
  friend class PassScope;
  PassSettings pass_;
  float exposure_ = 1.0f;
};

}  // namespace boxprobe
