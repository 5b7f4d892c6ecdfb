// A captured cube as an engine reads it: brought to a size, to another centre, filtered level by level from level 0,
// its axes the engine's. Plain values; knows no file.
#pragma once

#include <glm/mat3x3.hpp>

#include "filters/core/scene/model.h"
#include "filters/io/engines/ladder.h"
#include "filters/math/cube/cube_map.h"
#include "filters/math/cube/spherical_harmonics.h"

namespace boxprobe {

/// Level 0 of `cube` at a smaller power of two, each texel the mean of those it covers; the same size: a copy.
CubeMap resizedCube(const CubeMap& cube, int faceSize);

/// Along other axes: `cubeFromTurned` takes directions of the result to those of `cube`. One level.
CubeMap rotatedCube(const CubeMap& cube, const glm::mat3& cubeFromTurned);

/// Seen from `centre` instead of the origin, through what the box shows: exact where everything seen lies on the box.
/// `boxMin`, `boxMax` and `centre` in the frame of the cube, whose origin is where it was captured. One level.
CubeMap recentredCube(const CubeMap& cube, const glm::vec3& boxMin, const glm::vec3& boxMax, const glm::vec3& centre);

/// All levels of the ladder, each filtered from level 0 of `level0` with GGX (perceptual roughness of the row), in
/// OpenGL's orientation. `samples`: directions per texel of level 1, as PrefilterSettings has them.
CubeMap ladderChain(const CubeMap& level0, const LadderRow& ladder, int samples);

/// The cube's texels rearranged, exactly, so that sampling with d * lookup finds what was at d. All levels.
CubeMap turnedCube(const CubeMap& cube, const glm::vec3& lookup);

/// Irradiance over pi, one level; `worldFromCube` turns the cube's directions to the coefficients' (the world's).
CubeMap diffuseCube(const ShCoefficients& irradiance, const glm::mat3& worldFromCube, int faceSize);

/// Latitude-longitude, 4 faces wide and 2 high, texels at cell centres, `centre` (+X or +Z) in the middle.
ImageRgbaF latLongPicture(const CubeMap& cube, const glm::vec3& centre);

}  // namespace boxprobe
