// For comparison and teaching only: the farther of both planes of each axis instead of a selection (Lagarde and
// Zanuttini 2012; Arm), the form in most engines. A component of 0 gives +inf, as it should; with P on that face 0 / 0.
ProbeHit publishedBoxMax(ProbeShape probe, vec3 position, vec3 reflection)
{
  vec3 upper = (probe.boxMax - position) / reflection;
  vec3 lower = (probe.boxMin - position) / reflection;
  ProbeHit hit;
  hit.slabFactors = max(upper, lower);
  hit.distance = min(min(hit.slabFactors.x, hit.slabFactors.y), hit.slabFactors.z);
  hit.direction = position + reflection * hit.distance;
  hit.face = 0;
  hit.refined = 0.0f;
  return hit;
}
