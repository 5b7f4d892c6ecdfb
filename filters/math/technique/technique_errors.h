// How wrong the techniques are that `auto` chooses from, with one probe's own picture in its own box. What surrounds a
// probe decides more than the technique does: between saturated walls the same lookup is twice as wrong as in a pale
// room. Called once for a probe that uses `auto`, by the renderer and the benchmark; knows no GL.
#pragma once

#include "filters/math/shared/shared_math.h"
#include "filters/math/technique/automatic.h"

namespace boxprobe {

/// RMSE of (x/(1+x))^(1/2.2), at points on the box's walls and inside it, of all kinds of view, against many filtered
/// rays. About a hundred
/// thousand lookups, on all cores; the same inputs give the same errors. `probe`: the box, the frame and the level of
/// roughness 1; its projection and parameters are the candidates'. Raised by
/// a tenth for what a view of the box may show more of.
TechniqueErrors measureTechniqueErrors(const shading::CubeSampler& chain, const shading::ProbeShape& probe);

}  // namespace boxprobe
