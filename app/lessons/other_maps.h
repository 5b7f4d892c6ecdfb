// The same capture kept or sampled in other ways than the program's, for lessons on what those cost: mip levels that
// are plain means, faces that know nothing of their neighbours, CubeMapGen's edge fix-up. Called by PublishedPicture
// and by pictures of cubemaps. Directions in the map's axes, linear radiance with coverage in alpha.
#pragma once

#include "filters/math/cube/cube_map.h"

namespace boxprobe {

/// As many levels, each texel the mean of four of the level before, as glGenerateMipmap makes them.
CubeMap withPlainMeans(const CubeMap& cube);

/// Of every level but 0 the texels near an edge of a face pulled towards those across it, over at most `width` texels
/// and half a face (shaders/shared/edge_fixup.glsl; 4 in CubeMapGen).
CubeMap withEdgeFixup(const CubeMap& cube, int width);

/// Trilinear, each face for itself: at its border the edge texel is repeated, as by hardware without seamless lookups.
/// `direction` need not be unit; `level` is clamped.
glm::vec4 fetchWithinFace(const CubeMap& cube, const glm::vec3& direction, float level);

}  // namespace boxprobe
