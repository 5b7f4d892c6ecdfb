uniform samplerCube bpThroughMap@SLOT@;
uniform float bpThroughFaceSize@SLOT@;
uniform float bpThroughPerUnit@SLOT@;  // levels a unit where the light does not say

vec3 bpThroughSlot@SLOT@(vec3 position, vec3 toLight, float tangent, float perUnit)
{
  vec3 from = position - bpOrigin[@SLOT@];
#if BP_ROTATED
  from = transpose(bpWorldFromProbe[@SLOT@]) * from;
  toLight = transpose(bpWorldFromProbe[@SLOT@]) * toLight;
#endif
  vec3 factors = slabFactors(from, toLight, bpBoxMin[@SLOT@], bpBoxMax[@SLOT@]);
  float d = min(min(factors.x, factors.y), factors.z);
  vec3 hit = from + d * toLight;
  float level = perUnit < 0.0f ? coverageLevel(hit, factors, toLight, tangent, bpThroughFaceSize@SLOT@)
                               : d * (perUnit > 0.0f ? perUnit : bpThroughPerUnit@SLOT@);
#if BP_ROTATED
  hit = bpMapFromProbe[@SLOT@] * hit;
#endif
#if BP_DEBUG
  bpLookups += 1.0f;
#endif
  return textureLod(bpThroughMap@SLOT@, lookupDirection(hit), level).rgb;
}
