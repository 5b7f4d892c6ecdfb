// The pictures of `building`. Each side of the pavilion has its own colour, its own number of stripes and its own sign,
// so that one sees in a reflection which side it shows. Order of the sides everywhere: north, east, south, west.
#pragma once

#include "data/scenes/composer.h"

namespace boxprobe::scenes {

enum Side { kNorth, kEast, kSouth, kWest };
constexpr int kSides = 4;

Picture pillarPicture();   ///< four columns, one a side: a pillar face 0.5 m wide and 5 m high
Picture screenPicture();   ///< four columns, one a side: a wall panel with the side's sign
Picture parapetPicture();  ///< four rows, one a side: ten by five tiles
Picture stonePicture();    ///< tiles; 1.5 m of paving
Picture woodPicture();     ///< tiles; grain along u, 2 m by 1 m
Picture lawnPicture();     ///< tiles; 8 m of mown grass

}  // namespace boxprobe::scenes
