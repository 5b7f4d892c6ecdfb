// What probes saw, on the CPU: from their pictures, from baked files that still hold, or captured now. Called by
// `boxprobe export`.
#pragma once

#include <string>
#include <vector>

#include "app/session/load_scene.h"
#include "app/session/offscreen_choice.h"
#include "app/session/stats_json.h"
#include "filters/io/engines/probe_export.h"

namespace boxprobe {

class InterruptGuard;

struct CaptureWishes {
  std::vector<std::string> probes;  ///< names, all in the scene
  std::string bakedFolder;          ///< its files are used where they hold; empty: none
  Offscreen offscreen = Offscreen::Automatic;
  bool quiet = false;
};

struct CapturedProbes {
  std::vector<ProbeCapture> captures;
  RunStats stats;  ///< of what was captured
};

/// In the order of `wishes.probes`. A realtime probe is captured as it is now. Throws InputError for a custom probe
/// whose picture cannot be read, WorkError if it was interrupted or something could not be captured.
CapturedProbes captureProbes(const LoadedScene& loaded, const CaptureWishes& wishes, const InterruptGuard& interrupt);

}  // namespace boxprobe
