// Random box-shaped rooms: patterned walls from dark to bright, small and large ceiling lamps, windows; every fourth
// room is long and low. With surface points for measuring and fitting techniques.
#pragma once

#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "filters/math/cube/cube_map.h"
#include "filters/reference/study/padded_cube.h"

namespace boxprobe::study {

/// A pattern of two colours, brighter towards one end.
struct RoomWall {
  enum class Pattern { Checks, Stripes, Blocks, Grid, Waves };
  Pattern pattern = Pattern::Checks;
  glm::dvec3 light, dark;
  glm::dvec2 period;  ///< metres
  glm::dvec2 slope;   ///< change of brightness from end to end
};

/// A disk or rectangle in a wall.
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

/// A prefiltered capture of the room.
CubeMap prefilteredRoom(const BoxRoom& room, int faceSize);

/// The reflection at `point` of level 0 of the chain on the box: the split sum's mean over visible normals, integrated
/// in double precision and independently of the shaders. Uses level 0 instead of the room, so that the capture's
/// resolution does not count as a technique's error.
glm::dvec3 reflectedMean(const BoxRoom& room, const PaddedCube& chain, const shading::ShadingPoint& point, int rays);

/// A point of a surface and its reflected light.
struct RoomPoint {
  shading::ShadingPoint point;
  shading::ProbeShape probe;
  const PaddedCube* chain;
  glm::dvec3 truth;
  int roughness;  ///< the bucket, of kRoughnesses, that its roughness is in or near
  int angle;      ///< from above, oblique, grazing
};

constexpr int kRoughnesses = 6, kAngles = 3;

struct RoomPoints {
  std::vector<std::unique_ptr<PaddedCube>> chains;
  std::vector<RoomPoint> points;
};

/// Points on floors and walls, smooth and tilted as by a normal map, and on objects in the room; view angles up to 85
/// degrees, and one in eight from 60 to 87 towards a lamp's mirror image. If `goOn(rooms done)` returns false, the rest
/// is skipped. `f0`: ShadingPoint's, for all of them.
RoomPoints randomPoints(unsigned seed, int rooms, int pointsEach, int faceSize, int rays,
                        const std::function<bool(int)>& goOn = {}, float f0 = 1.0f);

}  // namespace boxprobe::study
