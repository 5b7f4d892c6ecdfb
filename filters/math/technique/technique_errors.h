// The errors of the techniques that `auto` chooses from, with one probe's own picture in its own box. The surroundings
// of a probe matter more than the technique: between saturated walls the same lookup is twice as wrong as in a pale
// room.
#pragma once

#include "filters/math/shared/shared_math.h"
#include "filters/math/technique/automatic.h"

namespace boxprobe {

/// RMSE of (x/(1+x))^(1/2.2), at points on the box's walls and inside it, for all kinds of view, against many filtered
/// rays. About a hundred thousand lookups, on all cores; deterministic. `probe`: the box, the frame and the level of
/// roughness 1; projection and parameters are those of the candidates. Raised by a tenth, because a view of the box may
/// show more of an error.
TechniqueErrors measureTechniqueErrors(const shading::CubeSampler& chain, const shading::ProbeShape& probe);

}  // namespace boxprobe
