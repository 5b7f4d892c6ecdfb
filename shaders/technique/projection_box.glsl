// Box projection: the ray from P along R leaves the box at the hit point; the cubemap is looked up with the direction
// from the capture origin (0 in the probe frame) to it. Exact where the scene is the box.
ProbeHit projectBox(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)
{
  vec3 factors = slabFactors(position, reflection, probe.boxMin, probe.boxMax);
  float t = min(min(factors.x, factors.y), factors.z);

  ProbeHit hit;
  hit.slabFactors = factors;
  hit.distance = t;
  // The clamp puts the hit on the box to the last bit and pulls in a start from outside.
  hit.direction = clamp(position + t * reflection, probe.boxMin, probe.boxMax);
  int axis = factors.x <= factors.y ? (factors.x <= factors.z ? 0 : 2) : (factors.y <= factors.z ? 1 : 2);
  float along = axis == 0 ? reflection.x : (axis == 1 ? reflection.y : reflection.z);
  hit.face = 2 * axis + (along < 0.0f ? 0 : 1);
  return hit;
}
