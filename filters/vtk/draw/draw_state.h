// What every draw of a scene renderer needs to know: shared by the renderer, the passes and the mappers. Four parts
// that live differently long: what there is (resources), how a pass draws (pass), what was drawn (counts), with which
// programs (programs).
#pragma once

#include <vtkWeakPointer.h>

#include "filters/vtk/draw/frame_counts.h"
#include "filters/vtk/draw/pass_settings.h"
#include "filters/vtk/draw/program_shelf.h"
#include "filters/vtk/draw/scene_resources.h"

class vtkRenderer;

namespace boxprobe {

/// One for all mappers of a scene renderer.
class DrawState {
 public:
  SceneResources resources;
  FrameCounts counts;
  ProgramShelf programs;
  /// Draws the window's picture: its camera's lights are uploaded again after a pass with another camera (PassScope).
  vtkWeakPointer<vtkRenderer> shown;

  const PassSettings& pass() const { return pass_; }

  /// What the window's own frames are drawn with, until it is set again. Not to be called while a PassScope lasts,
  /// whose end would undo it.
  void setExposure(float exposure) { pass_.exposure = exposure; }
  void setDragging(bool dragging) { pass_.dragging = dragging; }
  void setDebugView(const DebugView& debug) { pass_.debug = debug; }

 private:
  friend class PassScope;
  PassSettings pass_;
};

}  // namespace boxprobe
