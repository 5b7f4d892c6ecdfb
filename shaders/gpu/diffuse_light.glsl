// The probes' diffuse light: of lattices, and of nine coefficients where a probe has none. After bpShareOut.
// `position`: relative to the eye; it and the normal along the world's axes.
vec3 bpProbesIrradiance(vec3 position, vec3 normal)
{
  vec3 sum = vec3(0.0f);
  for (int slot = 0; slot < BP_EACH_SLOT; ++slot)
  {
    float weight = bpShareOf[slot] * bpIntensity[slot];
    if (weight > 1.0e-5f)
    {
#if BP_LATTICE
      if (bpLatticeLast[slot].x > 0.0f)
      {
        vec3 from = position - bpOrigin[slot];
        vec3 facing = normal;
#if BP_ROTATED
        from = transpose(bpWorldFromProbe[slot]) * from;
        facing = transpose(bpWorldFromProbe[slot]) * facing;
#endif
        sum += weight * latticeIrradiance(bpLatticeShape(slot), from, facing, normal);
#if BP_DEBUG
        float nodes = bpCoat ? 0.0f : weight / max(bpIntensity[slot], 1.0e-30f);
        bpNodeShare += nodes;
        bpNodeKnown += nodes * latticeKnown(bpLatticeShape(slot), from);
#endif
      }
      else
#endif
      {
        sum += weight * shIrradiance(normal, bpSh[9 * slot], bpSh[9 * slot + 1], bpSh[9 * slot + 2], bpSh[9 * slot + 3],
                                     bpSh[9 * slot + 4], bpSh[9 * slot + 5], bpSh[9 * slot + 6], bpSh[9 * slot + 7],
                                     bpSh[9 * slot + 8]);
      }
    }
  }
  return sum;
}
