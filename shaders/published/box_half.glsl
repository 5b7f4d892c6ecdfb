// For comparison and teaching only: box projection with the walls at half of (size - C) on both sides of the world's
// origin, as in three.js (getParallaxCorrectNormal of its node materials). Correct only if box and probe are centred at
// that origin. `origin`: C, `position`: P, both in the world; of the box only its size is used. Needs box_select.glsl.
ProbeHit publishedBoxHalf(ProbeShape probe, vec3 origin, vec3 position, vec3 reflection)
{
  vec3 wall = 0.5f * (probe.boxMax - probe.boxMin - origin);
  ProbeShape other = probe;
  other.boxMin = -wall;
  other.boxMax = wall;
  ProbeHit hit = publishedBoxSelect(other, position, reflection);
  hit.direction = hit.direction - origin;
  return hit;
}
