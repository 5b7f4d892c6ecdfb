// The values of a material's textures and vertices at a fragment, for features of glTF that VTK 9.1's texture code
// lacks: two sets of coordinates, transforms, factors without textures, alpha modes, clear-coat textures. BP_HAS_...
// and the sampling functions bpSample...() precede this, written by filters/vtk/surface/material_source.cpp for the
// existing textures.
uniform float bpAlpha;       // the base colour's factor
uniform float bpAlphaCutoff;

// Applies normal map `texel` in the frame of the normal `n`, which points to the front: glTF 2.0, section 3.9.3.
#if BP_TANGENT
vec3 bpMappedNormal(vec3 n, vec3 texel, float scale)
{
  vec3 along = bpTangentF.xyz - dot(bpTangentF.xyz, n) * n;
  float size = length(along);
  vec3 t = size > 0.0f ? along / size : vec3(0.0f);
  vec3 b = cross(n, t) * (bpTangentF.w < 0.0f ? -1.0f : 1.0f);
  vec3 mapped = (2.0f * texel - 1.0f) * vec3(scale, scale, 1.0f);
  vec3 turned = mapped.x * t + mapped.y * b + mapped.z * n;
  float turnedSize = length(turned);
  return turnedSize > 0.0f ? turned / turnedSize : n;
}
#endif

vec4 bpBaseColor()
{
  vec4 base = vec4(1.0f, 1.0f, 1.0f, bpAlpha);
#ifdef BP_HAS_BaseColor
  base *= bpSampleBaseColor();
#endif
#if BP_COLOR
  base *= bpColorF;
#endif
  return base;
}
