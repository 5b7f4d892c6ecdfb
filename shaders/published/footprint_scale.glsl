// For comparison and teaching only: the solid angle's scale (t / |d|)² cos_C / cos_P as printed, with squares of
// lengths first. They underflow in boxes of 1e-20, and overflow in boxes of 1e20.
float publishedFootprintScale(ProbeShape probe, ProbeHit hit, vec3 direction)
{
  vec3 d = hit.direction;
  vec3 w = vec3(hit.distance) / hit.slabFactors;
  w = w * w * w * w;
  vec3 plane = vec3(direction.x < 0.0f ? -probe.boxMin.x : probe.boxMax.x,
                    direction.y < 0.0f ? -probe.boxMin.y : probe.boxMax.y,
                    direction.z < 0.0f ? -probe.boxMin.z : probe.boxMax.z);
  float cosineC = dot(w, plane) / length(d);
  float cosineP = dot(w, abs(direction));
  return hit.distance * hit.distance / dot(d, d) * cosineC / cosineP;
}
