// Where a probe saw nothing, and the light of the sky that comes in there. CPU only, no VTK: called once a capture, and
// once more whenever the sky is another one; faces of kOpeningsFaceSize hold more than diffuse light's nine
// coefficients can.
#pragma once

#include <glm/mat3x3.hpp>

#include "filters/math/cube/cube_map.h"
#include "filters/math/cube/spherical_harmonics.h"

namespace boxprobe {

constexpr int kOpeningsFaceSize = 32;

/// Level 0 of `cube`, averaged down to at most `most` texels per side, which divide its own. One level.
CubeMap reducedCube(const CubeMap& cube, int most = kOpeningsFaceSize);

/// Is any texel's alpha, its coverage, less than a whole? Of a cube as captured: averages of half floats lose a crack.
bool anyOpening(const CubeMap& coverage);

/// Diffuse light of the sky through what `coverage` (alpha) leaves open, by world normals: to be added to that of the
/// premultiplied radiance. `worldFromMap`: rotation of the coverage's axes; the sky's are the world's.
ShCoefficients skyThroughOpenings(const CubeMap& coverage, const glm::dmat3& worldFromMap, const CubeMap& sky);

/// What a cube lets through, 1 - alpha of level 0, in levels of plain means down to one texel. `tint`: one level of the
/// colour of glass, null where there is none; `openIfWhole`: a picture that covers everything says nothing of openings.
CubeMap throughChain(const CubeMap& coverage, const CubeMap* tint = nullptr, bool openIfWhole = false);

}  // namespace boxprobe
