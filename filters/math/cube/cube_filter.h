// The prefilter on the CPU: the same directions, weights, source levels and lookups as on the graphics side, for
// machines without usable OpenGL and to check the other by. Threads through TBB; knows no VTK.
#pragma once

#include "filters/math/cube/cube_map.h"
#include "filters/math/sampling/filter_lobe.h"

namespace boxprobe {

/// Levels down to one texel per face.
int fullLevels(int faceSize);

/// Levels 1 and up of a source cube from its level 0. A constant stays constant.
void makeSourceLevels(CubeMap& source);

/// One level of `chain` from a source with all its levels. `edgeFixupWidth`: shaders/shared/edge_fixup.glsl; at most
/// half of the level's size is taken.
void filterCubeLevel(const CubeMap& source, CubeMap& chain, int level, const std::vector<LobeTap>& taps,
                     int edgeFixupWidth = 0);

/// The whole chain of a capture: level 0 of `capture` is what is read.
CubeMap prefilterCube(const CubeMap& capture, const PrefilterSettings& settings);

}  // namespace boxprobe
