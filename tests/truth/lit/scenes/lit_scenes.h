// The scenes in which an independent path tracer judges all of the light, as models: lamps, walls that light each
// other, a window, a sky. Called by generate_lit_scenes and its test. Their cameras, lights and skies stand in the
// scene files. Lengths are metres, +Y is up; north = -Z, east = +X, south = +Z, west = -X.
#pragma once

#include <string>

#include "filters/core/scene/model.h"

namespace boxprobe::scenes {

/// A closed room of 5.2 x 2.6 x 4.3 m with three lamps: a panel, a sconce, a glowing ball.
Model litClosed();

/// Two rooms of 2.7 m height, a wall with a doorway between them.
Model litDoorway();

/// A room whose only opening is a window in the east wall, 0.22 m thick.
Model litWindow();

/// A closed room with a table, shelves, a bench and a mirror, under a wide lamp.
Model litFurniture();

/// A vase, a brass ball and a black glossy block on a tiled slab, under a picture of a sky with a sun of some degrees.
Model litObject();
std::string litObjectSky();

/// The Cornell box as OBJ by Guedis Cardenas and Morgan McGuire, 2011 (public domain).
Model litCornell();

/// `livingRoom` as Godot's demo projects have it (MIT), every surface as Lambert's law.
Model litLivingRoom(const Model& livingRoom);

}  // namespace boxprobe::scenes
