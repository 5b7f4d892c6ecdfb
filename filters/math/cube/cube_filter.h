// The prefilter on the CPU: the same directions, weights, source levels and lookups as in OpenGL. For machines without
// usable OpenGL, and to check the OpenGL prefilter. Parallel through TBB.
#pragma once

#include "filters/math/cube/cube_map.h"
#include "filters/math/sampling/filter_lobe.h"

namespace boxprobe {

/// Levels down to one texel per face.
int fullLevels(int faceSize);

/// Makes levels 1 and up of a source cube from its level 0. A constant stays constant.
void makeSourceLevels(CubeMap& source);

/// Filters one level of `chain` from a source that has all its levels. `edgeFixupWidth`: see
/// shaders/shared/edge_fixup.glsl; clamped to half of the level's size.
void filterCubeLevel(const CubeMap& source, CubeMap& chain, int level, const std::vector<LobeTap>& taps,
                     int edgeFixupWidth = 0);

/// The whole chain of a capture, of which only level 0 is read.
CubeMap prefilterCube(const CubeMap& capture, const PrefilterSettings& settings);

}  // namespace boxprobe
