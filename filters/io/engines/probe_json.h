// The JSON beside an exported picture: where the probe is, what its file contains, and how an engine must read it. The
// files in data/engines parse it.
#pragma once

#include <string>

#include "filters/core/scene/scene.h"
#include "filters/io/engines/ladder.h"

namespace boxprobe {

/// How a probe was exported. The picture lies along the box's axes.
struct ExportedProbe {
  Probe probe;              ///< origin: where lookups start, the box's centre if the cube was recentred
  std::string file;         ///< name of the picture, in the same folder
  std::string diffuseFile;  ///< of the irradiance cube; empty: none
  std::string format;       ///< ktx2, dds, exr or hdr
  std::string writer;       ///< "Boxprobe 0.1.0"
  const LadderRow* ladder = nullptr;
  int faceSize = 0;
  int levels = 1;
  glm::dvec3 capturedAt{0.0};
};

/// JSON with a line break at its end. Lengths are scene units (metres), angles degrees, colours linear.
std::string probeJson(const ExportedProbe& exported);

}  // namespace boxprobe
