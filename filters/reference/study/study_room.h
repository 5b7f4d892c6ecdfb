// Rooms that are boxes, made up by chance: patterned walls from dark to bright, lamps small and large in the ceiling,
// windows; every fourth is long and low. With the points of their surfaces that techniques are judged and fitted by.
#pragma once

#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "filters/math/cube/cube_map.h"
#include "filters/reference/study/padded_cube.h"

namespace boxprobe::study {

/// A pattern in two colours, brighter towards one end.
struct RoomWall {
  enum class Pattern { Checks, Stripes, Blocks, Grid, Waves };
  Pattern pattern = Pattern::Checks;
  glm::dvec3 light, dark;
  glm::dvec2 period;  ///< metres
  glm::dvec2 slope;   ///< of the brightness from end to end
};

/// In a wall: a disk or a rectangle.
struct RoomLamp {
  int wall;
  bool round;
  glm::dvec2 middle;  ///< fraction of the wall
  glm::dvec2 half;    ///< metres
  glm::dvec3 radiance;
};

/// Walls -x +x -y +y -z +z; metres, relative to the capture origin.
struct BoxRoom {
  glm::dvec3 low, high;
  RoomWall walls[6];
  std::vector<RoomLamp> lamps;
};

BoxRoom randomRoom(unsigned seed, bool longAndLow);

/// A capture of the room, prefiltered.
CubeMap prefilteredRoom(const BoxRoom& room, int faceSize);

/// What `point` reflects of level 0 of the chain at the box: the mean over visible normals that the split sum takes, by
/// integration in double precision and independent of the shader's mathematics. Level 0 and not the room itself, so
/// that the capture's texels are not counted as a technique's error.
glm::dvec3 reflectedMean(const BoxRoom& room, const PaddedCube& chain, const shading::ShadingPoint& point, int rays);

/// A point of a surface and what it reflects.
struct RoomPoint {
  shading::ShadingPoint point;
  shading::ProbeShape probe;
  const PaddedCube* chain;
  glm::dvec3 truth;
  int roughness;  ///< one of kRoughnesses, or near it
  int angle;      ///< from above, oblique, grazing
};

constexpr int kRoughnesses = 6, kAngles = 3;

struct RoomPoints {
  std::vector<std::unique_ptr<PaddedCube>> chains;
  std::vector<RoomPoint> points;
};

/// Floors and walls, smooth and tilted as by a normal map, and things in the room; seen from up to 85 degrees, and one
/// in eight from 60 to 87 towards a lamp's mirror image.
/// `goOn(rooms done)` returning false leaves out the rest. `f0`: ShadingPoint's, of all of them.
RoomPoints randomPoints(unsigned seed, int rooms, int pointsEach, int faceSize, int rays,
                        const std::function<bool(int)>& goOn = {}, float f0 = 1.0f);

}  // namespace boxprobe::study
