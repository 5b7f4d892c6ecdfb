// The transmittance from a light outside a probe's box to a surface: for static objects the probe's coverage where the
// way to the light leaves the box, for moving objects a shadow map. Spliced in by filters/vtk/surface/probe_source.cpp
// after gpu/probe_lighting.glsl, only for draws with such a light, with gpu/coverage_slot.glsl before it for each slot.
// Needs shared/coverage.glsl.
uniform vec4 bpShadowLight[BP_SHADOW_LIGHTS];  // tangent of half the angle; radius, scene units; levels per unit, 0: the probe's own, negative: by size
uniform int bpShadowMask[BP_SLOTS];  // bit of a light: it is outside the probe's box

float bpUncovered;  // share of the pixel without a probe, which is not shadowed

void bpFindCovers(vec3 positionView)
{
  bpUncovered = bpShareOut(finiteOr(bpViewToWorld * positionView, vec3(0.0f)));
}

vec3 bpThrough(int light, int bit, vec3 positionView, vec3 normalView, vec3 toLightView, float distance)
{
  if (dot(normalView, toLightView) <= 0.0f) { return vec3(0.0f); }
  vec3 position = finiteOr(bpViewToWorld * positionView, vec3(0.0f));
  vec3 toLight = bpViewToWorld * toLightView;
  float tangent = bpShadowLight[light].x + bpShadowLight[light].y / max(distance, 1.0e-6f);
  float perUnit = bpShadowLight[light].z;
  vec3 through = vec3(bpUncovered);
//BP::Through
  return through;
}
