// Exports probes for an engine: each probe's picture and JSON, and the files that load both in the engine.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/math/cube/cube_map.h"
#include "filters/math/cube/spherical_harmonics.h"

namespace boxprobe {

/// A probe with its capture.
struct ProbeCapture {
  Probe probe;
  CubeMap level0;                    ///< only level 0 is read; OpenGL's orientation
  ShCoefficients irradiance{};       ///< of the world's normals
  glm::dvec3 capturedRotation{0.0};  ///< degrees: rotation of the axes of level0
  bool clamped = false;              ///< values beyond level0's range were clamped when it was captured
};

struct ExportSettings {
  std::string format = "ktx2";  ///< one of exportFormats()
  std::string ladder = "own";   ///< id of a row of ladderRows()
  int faceSize = 0;             ///< power of two, at most that of the captures; 0: as captured
  bool center = false;          ///< lookups start in the middle of the box, for engines without a separate origin
  bool lossy = false;           ///< clamp values that the format cannot hold instead of refusing them
  std::string writer;           ///< recorded in the files
};

const std::vector<std::string>& exportFormats();
/// Throws InputError for unknown or incompatible settings; messages use the command line's option names.
void checkExportSettings(const ExportSettings& settings);

/// Level 0 along the box's axes, with the requested size and origin; `probe.origin` is updated.
CubeMap exportedLevel0(const ProbeCapture& capture, const ExportSettings& settings, Probe& probe);

/// Writes into an existing folder; returns the paths. `progress` gets the finished fraction, 0 to 1, and may return
/// false to stop; complete files stay. Throws InputError, before anything is written, for conflicting names and, unless
/// lossy, for values that the format cannot hold; WorkError for file system errors.
std::vector<std::string> exportProbes(const std::vector<ProbeCapture>& captures, const ExportSettings& settings,
                                      const std::string& folder, const std::function<bool(double)>& progress = {});

}  // namespace boxprobe
