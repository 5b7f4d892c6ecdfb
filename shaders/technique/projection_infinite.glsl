// The bare reflection vector: every surface reflects as if it stood at the capture origin.
ProbeHit projectInfinite(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)
{
  ProbeHit hit;
  hit.direction = reflection;
  hit.distance = kNoHit;
  hit.face = -1;
  hit.refined = 0.0f;
  hit.slabFactors = vec3(kNoHit);
  return hit;
}
