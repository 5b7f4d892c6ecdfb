// One piece of work of the probe set: a cube map to make or to load. Planned by ProbePlan, done by ProbeBaker; plain
// data, knows neither OpenGL nor VTK.
#pragma once

#include <string>

namespace boxprobe {

enum class JobKind {
  SkyMap,    ///< the sky's own map, captured
  File,      ///< of a probe or the sky, read from the folder of baked files
  Picture,   ///< filtered from a picture of the user's
  Drag,      ///< a first bounce for the time of a drag
  Bounce,    ///< a bounce of a baked probe
  Realtime,  ///< a further round of a probe that follows what it shows
  Levels,    ///< of the sky, read from the file beside its picture
};

struct ProbeJob {
  JobKind kind = JobKind::Bounce;
  std::string name;  ///< of the probe; empty: the sky
  int bounce = 1;    ///< the first one is 1
  std::string key;   ///< of the maps it makes; empty for Realtime, whose key is known when all faces are
  int faceSize = 0;  ///< texels
  bool operator==(const ProbeJob& o) const { return kind == o.kind && name == o.name && key == o.key; }
};

/// Ends the key of maps that are captured during a drag: they show at once but do not count as the final ones.
constexpr const char* kDuringDrag = " during a drag";

}  // namespace boxprobe
