// Converts a captured cube for an engine: resized, recentred, each level filtered from level 0, turned to the engine's
// axes.
#pragma once

#include <glm/mat3x3.hpp>

#include "filters/core/scene/model.h"
#include "filters/io/engines/ladder.h"
#include "filters/math/cube/cube_map.h"
#include "filters/math/cube/spherical_harmonics.h"

namespace boxprobe {

/// Level 0 of `cube` at a smaller power of two, by averaging; a copy if the size is the same.
CubeMap resizedCube(const CubeMap& cube, int faceSize);

/// Along other axes: `cubeFromTurned` maps directions of the result to those of `cube`. One level.
CubeMap rotatedCube(const CubeMap& cube, const glm::mat3& cubeFromTurned);

/// As seen from `centre` instead of the origin, through what the box shows: exact where everything visible lies on the
/// box. `boxMin`, `boxMax` and `centre` are in the frame of the cube, whose origin is the capture origin. One level.
CubeMap recentredCube(const CubeMap& cube, const glm::vec3& boxMin, const glm::vec3& boxMax, const glm::vec3& centre);

/// All levels of the ladder, each filtered from `level0`'s level 0 with GGX (perceptual roughness of the row), in
/// OpenGL's orientation. `samples`: per texel of level 1, as in PrefilterSettings.
CubeMap ladderChain(const CubeMap& level0, const LadderRow& ladder, int samples);

/// The texels rearranged, exactly, so that sampling with d * lookup returns what was at d. All levels.
CubeMap turnedCube(const CubeMap& cube, const glm::vec3& lookup);

/// Irradiance over pi, one level; `worldFromCube` rotates the cube's directions to the coefficients' (the world's).
CubeMap diffuseCube(const ShCoefficients& irradiance, const glm::mat3& worldFromCube, int faceSize);

/// Latitude-longitude, 4 faces wide and 2 high, texels at cell centres, `centre` (+X or +Z) in the middle.
ImageRgbaF latLongPicture(const CubeMap& cube, const glm::vec3& centre);

}  // namespace boxprobe
