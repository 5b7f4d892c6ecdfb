// The translation unit that compiles shaders/shared/sheen.glsl, thin_film.glsl and anisotropy.glsl as C++.
#include "filters/math/shared/finish_math.h"

#include "filters/math/shared/glsl_built_ins.h"

namespace boxprobe::shading {

#include "shaders/shared/anisotropy.glsl"
#include "shaders/shared/sheen.glsl"
#include "shaders/shared/thin_film.glsl"

}  // namespace boxprobe::shading
