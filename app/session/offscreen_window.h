// A render window that never shows, for sub-commands and lessons: on an X display, or without any window system.
#pragma once

#include <vtkSmartPointer.h>

#include <cstddef>
#include <string>

#include "app/session/offscreen_choice.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

struct OffscreenSettings {
  std::string command;  ///< what the user called, for the advice where there is no display: "boxprobe render"
  int width = 16, height = 16;
  int samplesPerPixel = 1;   ///< brought down to what the driver offers; see GetMultiSamples()
  bool quiet = false;        ///< VTK's warnings are not printed
  bool printErrors = false;  ///< VTK's errors are printed as they come, for a program that goes on
  Offscreen offscreen = Offscreen::Automatic;
  /// What is drawn does not pay for well compiled shaders: Mesa's software renderers are told to compile them as they
  /// stand, which gives the same pixels, unless GALLIVM_PERF tells them something else.
  bool fewFrames = false;
  /// Beside a window that draws, from a thread of its own: VTK's messages and the environment stay as they are.
  bool beside = false;
};

/// For `fewFrames`: a frame of `building` with eight lookups takes 0.74 s of CPU time or, with shaders compiled in a
/// hurry, 0.95 s; to compile them well takes 1.4 s more. `probes`: to be captured at most.
inline bool drawsLittle(int frames, std::size_t probes) {
  return frames <= 6 && probes <= 8;
}

/// Takes over VTK's messages, then makes the window: initialised, its context current. Throws InputError where there is
/// nothing of the kind to draw with, WorkError where the driver refuses or has not what is needed.
vtkSmartPointer<vtkOpenGLRenderWindow> openOffscreenWindow(const OffscreenSettings& settings);

}  // namespace boxprobe
