// For comparison and teaching only: box projection as first published (Czuba 2010), and as in Unity and three.js: of
// both planes of each axis, the one ahead is selected by the ray's sign. A component of +0 selects (min - P) / 0 =
// -inf.
ProbeHit publishedBoxSelect(ProbeShape probe, vec3 position, vec3 reflection)
{
  vec3 upper = (probe.boxMax - position) / reflection;
  vec3 lower = (probe.boxMin - position) / reflection;
  ProbeHit hit;
  hit.slabFactors.x = reflection.x > 0.0f ? upper.x : lower.x;
  hit.slabFactors.y = reflection.y > 0.0f ? upper.y : lower.y;
  hit.slabFactors.z = reflection.z > 0.0f ? upper.z : lower.z;
  hit.distance = min(min(hit.slabFactors.x, hit.slabFactors.y), hit.slabFactors.z);
  hit.direction = position + reflection * hit.distance;
  hit.face = 0;
  hit.refined = 0.0f;
  return hit;
}
