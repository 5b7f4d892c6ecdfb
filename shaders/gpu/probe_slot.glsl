uniform PROBE_MAP bpMap@SLOT@;

void bpAddSlot@SLOT@(inout BpLight light, float weight, vec3 position, vec3 normal, vec3 view, vec3 reflection, float roughness,
                       float fresnel, float f0)
{
  ProbeShape probe;
  probe.boxMin = bpBoxMin[@SLOT@];
  probe.boxMax = bpBoxMax[@SLOT@];
  probe.maxLevel = bpMaxLevel[@SLOT@];
  probe.projection = @PROJECTION@;
  probe.bevel = @BEVEL@;
  probe.slot = @SLOT@;
@PARAMETERS@
  ShadingPoint point;
  point.position = position - bpOrigin[@SLOT@];
  point.normal = normal;
  point.view = view;
  point.reflection = reflection;
  point.roughness = roughness;
  point.pixel = ivec2(gl_FragCoord.xy) + bpPixelOrigin;
  point.frame = bpFrame;
  point.fresnel = fresnel;
  point.f0 = f0;
#if BP_ROTATED
  mat3 probeFromWorld = transpose(bpWorldFromProbe[@SLOT@]);
  point.position = probeFromWorld * point.position;
  point.normal = probeFromWorld * normal;
  point.view = probeFromWorld * view;
  point.reflection = probeFromWorld * reflection;
#endif

#if BP_DEBUG
  bpLevelSum = 0.0f;
  bpFetches = 0.0f;
#endif
@SPECULAR@#if @OCCLUDED@
#if BP_DEBUG
  float evaluated = bpLookups;  // the same hit again, which the compiler reuses
#endif
  specular *= boxOcclusion(projectRay(probe, point.position, point.normal, point.reflection).distance, bpOcclusion[@SLOT@].x,
                           bpOcclusion[@SLOT@].y, bpOcclusion[@SLOT@].z);
#if BP_DEBUG
  bpLookups = evaluated;
#endif
#endif
@OPEN_SKY@  vec3 reflected = weight * specular;
  light.specular += reflected;
#if BP_SAMPLED
  light.sampled += @SMOOTHED@ * reflected;
#endif
#ifdef BP_MIRROR
  light.share += weight;
#endif
#if BP_DIFFUSE
#if BP_LATTICE
  if (bpLatticeLast[@SLOT@].x > 0.0f)
  {
    vec3 facing = BP_FACING;
#if BP_ROTATED
    facing = probeFromWorld * facing;
#endif
    light.irradiance += weight * latticeIrradiance(bpLatticeShape(@SLOT@), point.position, facing, BP_FACING);
#if BP_DEBUG
    float nodes = bpCoat ? 0.0f : weight / max(bpIntensity[@SLOT@], 1.0e-30f);
    bpNodeShare += nodes;
    bpNodeKnown += nodes * latticeKnown(bpLatticeShape(@SLOT@), point.position);
#endif
  }
  else
#endif
  light.irradiance += weight * shIrradiance(BP_FACING, bpSh[9 * @SLOT@], bpSh[9 * @SLOT@ + 1], bpSh[9 * @SLOT@ + 2],
                                            bpSh[9 * @SLOT@ + 3], bpSh[9 * @SLOT@ + 4], bpSh[9 * @SLOT@ + 5],
                                            bpSh[9 * @SLOT@ + 6], bpSh[9 * @SLOT@ + 7], bpSh[9 * @SLOT@ + 8]);
#endif
#if BP_DEBUG
  float share = weight / max(bpIntensity[@SLOT@], 1.0e-30f);
  bpWeightColor += bpCoat ? vec3(0.0f) : share * bpProbeColor[@SLOT@];
  if (!bpCoat && share > bpBest.share)
  {
    vec3 offset = position - bpOrigin[@SLOT@];
    bpBest.share = share;
    float lookups = bpLookups;  // lookups of the view itself do not count
    bpBest.hit = projectRay(probe, point.position, point.normal, point.reflection);
    bpLookups = lookups;
    bpBest.lookup = bpBest.hit.direction;
#if BP_ROTATED
    bpBest.lookup = bpWorldFromProbe[@SLOT@] * bpBest.lookup;
#endif
    bpBest.levelSum = bpLevelSum;
    bpBest.fetches = bpFetches;
    bpBest.maxLevel = probe.maxLevel;
    bpBest.trueDistance = kNoHit;
    if (bpDistanceFaceSize[@SLOT@] > 0.0f && bpView >= 2 && bpView <= 4)
    {
      vec3 from = point.position;
      vec3 along = point.reflection;
#if BP_ROTATED
      from = bpMapFromProbe[@SLOT@] * from;
      along = bpMapFromProbe[@SLOT@] * along;
#endif
      bpBest.trueDistance = trueHitDistance(bpDistanceMap@SLOT@, probe, bpDistanceFaceSize[@SLOT@], from, along,
                                            2.0f * length(probe.boxMax - probe.boxMin));
    }
    bpBest.truth = offset + bpBest.trueDistance * reflection;
  }
#endif
}
