// State for every draw of a renderer, shared by the renderer, its passes and the passes of its actors. Its parts have
// different lifetimes: resources, the settings of a pass, results of draws (counts), tuning for drivers, and the draw
// in progress (drawing, bound).
#pragma once

#include <vtkWeakPointer.h>

#include <memory>
#include <optional>
#include <vector>

#include "filters/vtk/draw/frame_counts.h"
#include "filters/vtk/draw/pass_settings.h"
#include "filters/vtk/draw/scene_resources.h"
#include "filters/vtk/draw/window_view.h"
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
  /// The renderer of the window's picture: its camera's lights are uploaded again after a pass with another camera
  /// (PassScope).
  vtkWeakPointer<vtkRenderer> shown;
  /// What stands before this box is left out by `shown` alone.
  std::optional<CutBox> cut;
  /// The renderer that draws now, whose camera uniforms are relative to. Null: none of ours, and surfaces have VTK's
  /// own programs.
  vtkRenderer* drawing = nullptr;
  std::vector<std::unique_ptr<BoundTexture>> bound;  ///< for the piece drawn last

  const PassSettings& pass() const { return pass_; }

  /// The exposure of the window's own frames. Must not be called during a PassScope, whose end would undo it.
  void setExposure(float exposure) { exposure_ = pass_.exposure = exposure; }
  /// The exposure of the window's own frames, also during a PassScope.
  float exposure() const { return exposure_; }
  void setDragging(bool dragging) { pass_.dragging = dragging; }
  void setDebugView(const ShownDebugView& debug) { pass_.debug = debug; }

 private:
  friend class PassScope;
  PassSettings pass_;
  float exposure_ = 1.0f;
};

}  // namespace boxprobe
