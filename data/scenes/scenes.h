// The scenes that come with the program, as models. Called by generate_scenes and its test; knows no file format.
// All lengths metres, +Y up. Compass names: north = -Z, east = +X, south = +Z, west = -X.
#pragma once

#include <string>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe::scenes {

/// An open pavilion around an inner space of 9 x 5 x 9 m, with a mirror for a floor and nine mirror spheres.
Model building();

/// A closed 8 x 3 x 6 m room whose walls lie exactly in the planes of its box: box projection is exact in it.
Model room();

/// A closed 7 x 2.8 x 5 m room whose walls lie in the planes of its box and whose furniture does not: box projection
/// paints that on the walls.
Model furnished();

/// A closed 4 x 4 x 4 m room, one colour a wall, that shows a swapped, mirrored or turned cube-map face at a glance.
Model sixFaces();

/// A closed 10 x 3.5 x 7 m room with textures and small bright lamps, and things to reflect them: for measuring.
Model gallery();

/// A closed 8 x 3.2 x 6 m room with openings of every size to the sky and the sun, its walls in the planes of its box.
Model windows();

/// A closed 6 x 3 x 5 m room whose walls lie in the planes of its box, with six things of glass: a ball, a block that
/// absorbs, a prism, a ring, a cup and a thin pane.
Model glassRoom();

/// A closed 12 x 4 x 8 m hall with mirrors on a wall and the floor, and things that move before them.
Model mirrorHall();

/// A furnished flat: a living room of 5.6 x 2.6 x 4.6 m and a kitchen of 4.6 x 2.6 x 3 m with a doorway between them.
/// Its pictures are meant for JPEG: glbBytes(flat(), kFlatJpegQuality).
Model flat();
constexpr int kFlatJpegQuality = 88;

/// What is seen through its windows, a latitude-longitude picture: an evening sky over hills and trees.
std::string flatSkyHdr();

struct Apartments {
  Model model;
  Scene scene;  ///< without its model's file name
};

/// `rooms` rooms at corridors that four of them share, a probe in each room and each corridor; the same seed, the same
/// scene, and the first four rooms are the same for any number of them.
Apartments apartments(int rooms, unsigned seed);

/// The sky of `building` as a Radiance HDR file, latitude-longitude, for programs that want an image.
std::string skyHdr();

}  // namespace boxprobe::scenes
