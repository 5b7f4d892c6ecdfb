// The smallest scene in which "this probe, not the other" can be said: for tests of the Document and of scenes as
// values.
#pragma once

#include "filters/core/scene/scene.h"

namespace boxprobe {

inline Scene twoProbes() {
  Scene scene;
  scene.probes.resize(2);
  scene.probes[0].name = "room";
  scene.probes[1].name = "hall";
  return scene;
}

}  // namespace boxprobe
