// The scenes that an independent path tracer judges the references in, as models. Everything but the floor emits light
// and reflects nothing, in pictures that differ from side to side, so that a wrong direction shows. Called by
// generate_truth_scenes and its test; knows no file format and no renderer.
// Lengths are metres, +Y is up; north = -Z, east = +X, south = +Z, west = -X.
#pragma once

#include <string>

#include "filters/core/scene/model.h"

namespace boxprobe::scenes {

/// A closed room of 6.4 x 2.7 x 5.2 m that is exactly its probe's box, with four lamps in its walls.
Model truthEmpty();

/// A closed room of 5.8 x 2.5 x 4.8 m with a table, shelves, a sofa, a cabinet and a hanging lamp.
Model truthFurnished();

/// A hall of 9 x 3.4 x 7 m between pillars 0.9 m thick, open to the sky on all four sides.
Model truthArcade();
/// Its sky: latitude-longitude, Radiance HDR, another colour in each quarter and a soft sun in the south-west.
std::string truthArcadeSky();

}  // namespace boxprobe::scenes
