// A flat of two rooms on a large plain, as a drawing program would save it. Called by the tests of placing probes.
#pragma once

#include "filters/core/scene/model.h"

namespace boxprobe::test {

struct FlatWishes {
  double unitsPerMetre = 1.0;
  double yawDegrees = 0.0;
  double groundMetres = 0.0;  ///< side of a plain below; 0: none
  bool inverted = false;      ///< every triangle turned over
  float roughness = 0.1f;
};

/// Two rooms of 4 x 2.6 x 3 and 5 x 2.6 x 3 m side by side along x, the middle of the first at (-2.1, 1.3, 0), of the
/// second at (2.6, 1.3, 0), before they are turned about +y. Between them 0.2 m of wall with a door of 0.9 x 2 m; a
/// table in the second. One mesh.
Model madeFlat(const FlatWishes& wishes = {});

}  // namespace boxprobe::test
