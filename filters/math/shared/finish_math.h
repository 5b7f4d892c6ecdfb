// shaders/shared/sheen.glsl, thin_film.glsl and anisotropy.glsl as C++: material properties beyond metalness and
// roughness. The definitions are in finish_math.cpp.
#pragma once

#include "filters/math/shared/shared_math.h"

namespace boxprobe::shading {

float sheenLobe(float nDotH, float nDotV, float nDotL, float roughness);
float sheenAlbedo(float nDotV, float roughness);
float underSheen(vec3 color, float nDotV, float roughness);

vec3 filmReflectance(vec3 base, float ior, float thickness, float cosine);
vec3 filmNormalReflectance(vec3 reflectance, float cosine);

vec2 anisotropicAlpha(float alpha, float strength);
float anisotropicLobe(vec3 toView, vec3 toLight, vec3 halfway, vec2 alpha);
vec3 anisotropicNormal(vec3 normal, vec3 view, vec3 across, float roughness, float strength);

}  // namespace boxprobe::shading
