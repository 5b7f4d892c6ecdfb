// "Painted on": looked up with the surface normal, as if the picture were printed on the object. For teaching.
ProbeHit projectNormal(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)
{
  ProbeHit hit;
  hit.direction = normal;
  hit.distance = kNoHit;
  hit.face = -1;
  hit.refined = 0.0f;
  hit.slabFactors = vec3(kNoHit);
  return hit;
}
