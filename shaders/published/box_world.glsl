// For comparison and teaching only: the same in world coordinates, with (P + t R) - C last: far from the world's origin
// the lookup has lost most of its digits. `origin`: C, `position`: P, `boxMin` and `boxMax`: all in the world. Needs
// box_max.glsl.
ProbeHit publishedBoxWorld(ProbeShape probe, vec3 origin, vec3 position, vec3 reflection)
{
  ProbeHit hit = publishedBoxMax(probe, position, reflection);
  hit.direction = hit.direction - origin;
  return hit;
}
