// Box projection: the ray from P along R leaves the box at the hit point; the cubemap is sampled in the direction from
// the capture origin (0 in the probe frame) to it. Exact if the scene is the box. Hosts that round its edges define
// BP_BEVEL and supply shared/rounded_box.glsl.
ProbeHit projectBox(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)
{
  vec3 factors = slabFactors(position, reflection, probe.boxMin, probe.boxMax);
  float t = min(min(factors.x, factors.y), factors.z);

  ProbeHit hit;
  hit.slabFactors = factors;
#ifdef BP_BEVEL
  if (probe.bevel > 0.0f)
  {
    float rounded = roundedBoxExit(position, reflection, probe.boxMin, probe.boxMax, probe.bevel, t);
    // The box scaled about P until its face contains the hit; see ProbeHit.
    if (rounded < t) { hit.slabFactors = min(factors, vec3(1.0e30f)) * (rounded / t); }
    t = rounded;
  }
#endif
  hit.distance = t;
  // The clamp makes the hit exactly on the box, and moves a start from outside onto it.
  hit.direction = clamp(position + t * reflection, probe.boxMin, probe.boxMax);
  int axis = factors.x <= factors.y ? (factors.x <= factors.z ? 0 : 2) : (factors.y <= factors.z ? 1 : 2);
  float along = axis == 0 ? reflection.x : (axis == 1 ? reflection.y : reflection.z);
  hit.face = 2 * axis + (along < 0.0f ? 0 : 1);
  hit.refined = 0.0f;
  return hit;
}
