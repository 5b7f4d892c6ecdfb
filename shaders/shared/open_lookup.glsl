// The sky's direction for a lookup in a probe that is open to the sky. xyz: from the surface to the lookup's hit on the
// box, probe frame; w: the perceptual roughness with the same width there. `position`: of the surface, probe frame;
// `direction` and `level`: of the lookup; `alpha`: of the surface, an upper bound. Needs slab.glsl, roughness.glsl.
vec4 openLookup(ProbeShape probe, vec3 position, vec3 direction, float level, float alpha)
{
  vec3 a = abs(direction);
  vec3 unit = direction / max(max(a.x, a.y), max(a.z, 1.0e-37f));
  unit = unit / length(unit);
  vec3 factors = slabFactors(vec3(0.0f), unit, probe.boxMin, probe.boxMax);
  float fromC = min(min(factors.x, factors.y), factors.z);
  vec3 away = fromC * unit - position;
  float fromP = length(away);
  // A capture origin outside its box, or a surface in the opening itself: uses the lookup's own direction.
  if (fromC <= 0.0f || fromC >= 1.0e18f || fromP <= 1.0e-6f * fromC) { return vec4(unit.x, unit.y, unit.z, sqrt(alpha)); }
  vec3 onFace = vec3(factors.x <= fromC ? 1.0f : 0.0f, factors.y <= fromC ? 1.0f : 0.0f, factors.z <= fromC ? 1.0f : 0.0f);
  vec3 along = away / fromP;
  float cosineC = max(dot(onFace, abs(unit)), 1.0e-3f);
  float cosineP = max(dot(onFace, abs(along)), 1.0e-3f);
  // The same patch seen from the other end: see footprint.glsl.
  float roughness = roughnessForLevel(level, probe.maxLevel);
  float width = roughness * roughness * (fromC / fromP) * sqrt(cosineP / cosineC);
  return vec4(along.x, along.y, along.z, sqrt(min(width, alpha)));
}
