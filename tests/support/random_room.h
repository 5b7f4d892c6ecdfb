// Rooms made by chance, to fit boxes to: furniture, windows, doorways, L-shapes, open sides, sloped ceilings, turned
// and double-height ones. Called by fit_rooms and by the tests of the fit.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe::test {

struct RandomRoom {
  std::string what;                    ///< "L-shape, turned, 7 pieces of furniture"
  Scene scene;                         ///< cameras, and a probe: captured somewhere in the free space, box of 2 m
  std::shared_ptr<const Model> model;  ///< one, of a mesh for each material
  double yawDegrees = 0.0;             ///< of the room about +y
  glm::dvec3 halfSize{0.0};            ///< of its main part: x, y (half the height), z
};

/// The same room for the same seed, on every machine. Every eight in a row show each feature once.
RandomRoom randomRoom(std::uint32_t seed);

}  // namespace boxprobe::test
