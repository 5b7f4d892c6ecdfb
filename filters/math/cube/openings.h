// Where a probe saw nothing, and the light of the sky that comes in there. Computed once per capture and once per
// change of the sky. Faces of kOpeningsFaceSize hold more detail than the nine coefficients of diffuse light can.
#pragma once

#include <glm/mat3x3.hpp>

#include "filters/math/cube/cube_map.h"
#include "filters/math/cube/spherical_harmonics.h"

namespace boxprobe {

constexpr int kOpeningsFaceSize = 32;

/// Level 0 of `cube` averaged down to at most `most` texels per side, which must divide its size. One level.
CubeMap reducedCube(const CubeMap& cube, int most = kOpeningsFaceSize);

/// Is the alpha (coverage) of any texel below 1? `coverage` must be a cube as captured: averages of half floats lose a
/// thin crack.
bool anyOpening(const CubeMap& coverage);

/// Diffuse light of the sky through what `coverage` (alpha) leaves open, by world normals; to be added to that of the
/// premultiplied radiance. `worldFromMap`: rotation of the coverage's axes; the sky lies along the world's.
ShCoefficients skyThroughOpenings(const CubeMap& coverage, const glm::dmat3& worldFromMap, const CubeMap& sky);

/// Transmittance of a cube: 1 - alpha of level 0, in levels of plain means down to one texel. `tint`: one level with
/// the colour of glass, null without glass. `openIfWhole`: a picture that covers everything tells nothing of openings,
/// and counts as open.
CubeMap throughChain(const CubeMap& coverage, const CubeMap* tint = nullptr, bool openIfWhole = false);

}  // namespace boxprobe
