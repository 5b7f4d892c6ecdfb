// Exit of a ray from a box. Total: for finite input the result is finite and the hit is on or in the box.

// Larger than any distance of interest and still finite, so that a zero direction component never gives infinity (which
// would become NaN when multiplied by that zero).
const float kNoHit = 3.0e38f;

// Distance along `direction` to the exit plane of one axis. A start beyond the exit plane gives 0, because it has
// passed it. The comparison replaces `direction != 0`: it also keeps the quotient below kNoHit for denormal directions.
float slabFactor(float position, float direction, float boxMin, float boxMax)
{
  float gap = max(direction < 0.0f ? position - boxMin : boxMax - position, 0.0f);
  float speed = abs(direction);
  return speed * kNoHit > gap ? gap / speed : kNoHit;
}

// The three exit distances; the smallest is the exit from the box.
vec3 slabFactors(vec3 position, vec3 direction, vec3 boxMin, vec3 boxMax)
{
  return vec3(slabFactor(position.x, direction.x, boxMin.x, boxMax.x),
              slabFactor(position.y, direction.y, boxMin.y, boxMax.y),
              slabFactor(position.z, direction.z, boxMin.z, boxMax.z));
}
