// For comparison and teaching only: exit from the sphere around the box by the textbook quadratic formula. It cancels
// where P is near the sphere, squares lengths unscaled, and has no root if the ray misses.
ProbeHit publishedSphere(ProbeShape probe, vec3 position, vec3 reflection)
{
  vec3 o = position - 0.5f * (probe.boxMin + probe.boxMax);
  float radius = 0.5f * length(probe.boxMax - probe.boxMin);
  float b = dot(o, reflection);
  float c = dot(o, o) - radius * radius;
  ProbeHit hit;
  hit.distance = -b + sqrt(b * b - c);
  hit.direction = position + hit.distance * reflection;
  hit.face = -1;
  hit.refined = 0.0f;
  hit.slabFactors = vec3(0.0f);
  return hit;
}
