// Probes written for an engine: each one's picture with the JSON beside it, and the files that take both into the
// engine. Called by `boxprobe export` and the window; knows no renderer.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/math/cube/cube_map.h"
#include "filters/math/cube/spherical_harmonics.h"

namespace boxprobe {

/// A probe with what it saw.
struct ProbeCapture {
  Probe probe;
  CubeMap level0;                    ///< its level 0 is read, in OpenGL's orientation
  ShCoefficients irradiance{};       ///< of the world's normals
  glm::dvec3 capturedRotation{0.0};  ///< degrees: the axes that level0 lies along
  bool clamped = false;              ///< its source was brighter than level0 holds
};

struct ExportSettings {
  std::string format = "ktx2";  ///< one of exportFormats()
  std::string ladder = "own";   ///< id of a row of ladderRows()
  int faceSize = 0;             ///< power of two, at most that of the captures; 0: each as captured
  bool center = false;          ///< lookups start in the middle of the box, as engines without another origin have it
  bool lossy = false;           ///< write what the format cannot hold as the nearest value it can
  std::string writer;           ///< named in the files
};

const std::vector<std::string>& exportFormats();
/// Throws InputError naming what is unknown or does not go together; `option` strings are those of the command line.
void checkExportSettings(const ExportSettings& settings);

/// Level 0 along the box's axes, at the size and around the origin that are asked for; `probe.origin` follows.
CubeMap exportedLevel0(const ProbeCapture& capture, const ExportSettings& settings, Probe& probe);

/// Writes into an existing folder; returns the paths. `progress` gets the finished share, 0..1, and may return false to
/// stop: whole files stay. Throws InputError, before anything is written, for names that clash and, unless lossy, for
/// values that the format cannot hold; WorkError for the file system's failures.
std::vector<std::string> exportProbes(const std::vector<ProbeCapture>& captures, const ExportSettings& settings,
                                      const std::string& folder, const std::function<bool(double)>& progress = {});

}  // namespace boxprobe
