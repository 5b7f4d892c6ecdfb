// The box's hit, refined by what the probe saw (a distance impostor), for rooms that are not boxes. Up to three `steps` look at a few places
// where something may stand; more follow the ray through all that was seen. The distance cubemap has been prepared (filters/math/cube/relief.h): a lookup gives the plane q of the surface seen in a direction, {x : dot(q, x) = 1}, so that a
// point X lies behind what was seen where s = dot(q, X) is above 1, in front of it below 1, and a flat surface is met exactly
// in one step. Blocks are boxes around what stands in the room. With at most three lookups:
//   a block the ray meets is looked at just behind where the ray enters, then where it leaves;
//   else the box's hit: on the box it stays. Beyond it the ray goes on to the plane seen there, or far away;
//   what is hidden from the capture origin cannot be found: the ray is then looked up where it was seen last.
// Needs technique/projection_box.glsl, shared/relief_march.glsl; the host supplies fetchProbePlane, fetchProbeFar (the direction to look in for what is
// far away) and the blocks.

// BP_MARCH is defined by hosts that know which forms are drawn: 0 up to three steps, 2 more than three, 1 both.

// How far along the ray its plane is met; -1 if it is not, or farther than `farthest`.
float impostorMeets(vec3 plane, vec3 position, vec3 reflection, float farthest)
{
  float gap = 1.0f - dot(plane, position);
  float speed = dot(plane, reflection);
  return gap * speed > 0.0f && abs(gap) < farthest * abs(speed) ? gap / speed : -1.0f;
}

// Where the ray is in a block.
struct ImpostorSpan
{
  float enter; // 0 if it starts inside; kNoHit: no block
  float leave;
};

// Of the first block that is entered later than `after` and left later than `least`.
ImpostorSpan impostorSpan(ProbeShape probe, vec3 position, vec3 reflection, float after, float least)
{
  ImpostorSpan span;
  span.enter = kNoHit;
  span.leave = kNoHit;
  // Divided by next to nothing rather than by 0: beyond any block all the same.
  vec3 inverse = vec3(1.0f) / vec3(abs(reflection.x) > 1.0e-18f ? reflection.x : 1.0e-18f,
                                   abs(reflection.y) > 1.0e-18f ? reflection.y : 1.0e-18f,
                                   abs(reflection.z) > 1.0e-18f ? reflection.z : 1.0e-18f);
  int count = probeBlockCount(probe);
  for (int i = 0; i < count; ++i)
  {
    vec3 a = (probeBlockLow(probe, i) - position) * inverse;
    vec3 b = (probeBlockHigh(probe, i) - position) * inverse;
    vec3 first = min(a, b);
    vec3 last = max(a, b);
    float enter = max(max(max(first.x, first.y), first.z), 0.0f);
    float leave = min(min(last.x, last.y), last.z);
    if (leave > enter && leave > least && enter > after && enter < span.enter)
    {
      span.enter = enter;
      span.leave = leave;
    }
  }
  return span;
}

// The hit moved along the ray, seen from C in `direction`: the box scaled about P until its face goes through it, so that evaluations
// have a wall's normal and distance to work with.
ProbeHit impostorAt(ProbeHit box, float t, vec3 direction)
{
  ProbeHit hit = box;
  hit.slabFactors = min(box.slabFactors, vec3(1.0e30f)) * (t / box.distance);
  hit.refined = 1.0f;
  hit.distance = t;
  hit.direction = direction;
  return hit;
}

#if BP_MARCH < 2
// At most three further samples.
ProbeHit impostorRefined(ProbeShape probe, vec3 position, vec3 reflection, ProbeHit box)
{
  const float kOn = 0.015f;      // s this near to 1 lies on the surface: half a texel of a 256² face on a wall seen at 75 degrees
  const float kBehind = 1.01f;   // s of a point behind what was seen: less is rounding, and blocks are larger than what is in them
  const float kMet = 0.03f;      // s this near to 1 where a plane is met: the surface goes on to there
  const float kInto = 0.02f;     // of the way through a block: just behind its front
  const float kSlack = 0.01f;    // of the box's distance: by how much what is in a block may stand out of it
  const float kReveal = 1.15f;   // times the box's distance: as far into an opening as its sides are looked for
  const float kFarthest = 100.0f;  // times the box's distance
  float tBox = box.distance;
  float left = probe.parameters.steps;
  float farthest = kFarthest * tBox;

  float after = -1.0f;
  for (int k = 0; k < 2; ++k)
  {
    if (left < 2.0f) { break; }
    ImpostorSpan span = impostorSpan(probe, position, reflection, after, kSlack * tBox);
    if (span.enter > 0.999f * tBox) { break; }
    after = span.enter;
    float leave = min(span.leave, tBox);
    float low = max(span.enter - kSlack * tBox, kSlack * tBox);
    float high = leave + kSlack * tBox;
    for (int end = 0; end < 2; ++end)
    {
      if (left < 2.0f || (end == 0 && span.enter < 2.0f * kSlack * tBox)) { continue; }
      float t = end == 0 ? mix(span.enter, leave, kInto) : leave;
      vec3 x = position + t * reflection;
      vec3 plane = fetchProbePlane(probe, x);
      left = left - 1.0f;
      bool behind = dot(plane, x) > kBehind;
      float met = impostorMeets(plane, position, reflection, farthest);
      if (met > low && met < high && (behind ? met <= t : met >= t - kSlack * tBox))
      {
        return impostorAt(box, met, position + met * reflection);
      }
      // Hidden by something else: of this block only its box is known.
      if (behind && end == 0) { return impostorAt(box, t, x); }
    }
  }

  if (left < 1.0f) { return box; }
  vec3 plane = fetchProbePlane(probe, box.direction);
  left = left - 1.0f;
  float s = dot(plane, box.direction);
  float met = impostorMeets(plane, position, reflection, farthest);
  if (abs(s - 1.0f) < kOn) { return box; }
  if (s < 1.0f)
  {
    if (met > tBox)
    {
      if (left < 1.0f) { return impostorAt(box, met, position + met * reflection); }
      vec3 x = position + met * reflection;
      vec3 next = fetchProbePlane(probe, x);
      left = left - 1.0f;
      float there = dot(next, x);
      if (abs(there - 1.0f) < kMet) { return impostorAt(box, met, x); }
      float nearer = impostorMeets(next, position, reflection, farthest);
      if (there > 1.0f && nearer > tBox && nearer < met) { return impostorAt(box, nearer, position + nearer * reflection); }
    }
    // What stands outside is seen through the opening.
    after = 0.999f * tBox;
    for (int k = 0; k < 2; ++k)
    {
      if (left < 2.0f) { break; }
      ImpostorSpan span = impostorSpan(probe, position, reflection, after, kSlack * tBox);
      if (span.enter > farthest) { break; }
      after = span.enter;
      float t = 0.5f * (span.enter + min(span.leave, farthest));
      vec3 x = position + t * reflection;
      vec3 next = fetchProbePlane(probe, x);
      left = left - 1.0f;
      float there = impostorMeets(next, position, reflection, farthest);
      // Behind what is seen there and met before, or the other way round.
      if (there > span.enter - kSlack * tBox && there < span.leave + kSlack * tBox && (dot(next, x) > 1.0f ? there <= t : there >= t))
      {
        return impostorAt(box, there, position + there * reflection);
      }
    }
    // The sides of what the opening is in.
    if (left >= 2.0f && met <= tBox)
    {
      vec3 x = position + kReveal * tBox * reflection;
      float there = impostorMeets(fetchProbePlane(probe, x), position, reflection, farthest);
      left = left - 1.0f;
      if (there > tBox && there < kReveal * kReveal * tBox) { return impostorAt(box, there, position + there * reflection); }
    }
    if (left >= 1.0f)
    {
      vec3 away = fetchProbeFar(probe, reflection);
      if (dot(away, away) > 0.0f) { return impostorAt(box, farthest, farthest * away); }
    }
    return met > tBox ? impostorAt(box, met, position + met * reflection) : box;
  }
  if (met > 0.0f && met < tBox)
  {
    vec3 x = position + met * reflection;
    if (left < 1.0f) { return impostorAt(box, met, x); }
    float there = dot(fetchProbePlane(probe, x), x);
    // There, or passing it on its near side: the last that was seen of the ray.
    if (there < 1.0f + kMet) { return impostorAt(box, met, x); }
  }
  return box;
}
#endif

#if BP_MARCH > 0
// The ray followed through the captured distances (shared/relief_march.glsl), one sample a step. What it may meet before the box is in
// the blocks, so it starts at the first one or at the box: empty space costs nothing.
ProbeHit impostorMarched(ProbeShape probe, vec3 position, vec3 reflection, ProbeHit box)
{
  const float kSlack = 0.01f;      // of the box's distance: by how much what is in a block, or on the box, may stand out of it
  const float kFarthest = 100.0f;  // times the box's distance
  float tBox = box.distance;
  ImpostorSpan span = impostorSpan(probe, position, reflection, -1.0f, kSlack * tBox);
  float start = max(min(span.enter, tBox) - kSlack * tBox, 0.0f);
  float farthest = kFarthest * tBox;
  // The last sample is kept for what is far away.
  ReliefMarch march = marchRelief(probe, position, reflection, start, farthest, probe.parameters.steps - 1.0f);
  if (march.met >= 0.0f) { return impostorAt(box, march.met, position + march.met * reflection); }
  // Hidden to its end, or out of the box as far as the steps went.
  if (march.lost > 0.0f || march.way > tBox)
  {
    vec3 away = fetchProbeFar(probe, reflection);
    if (dot(away, away) > 0.0f) { return impostorAt(box, farthest, farthest * away); }
  }
  if (march.lost > 0.0f) { return impostorAt(box, march.lost, position + march.lost * reflection); }
  // Hidden from its start, or undecided before the box: whatever is seen there is as near as anything that is known.
  if (march.way > 0.0f && (march.lost == 0.0f || march.way < tBox))
  {
    return impostorAt(box, march.way, position + march.way * reflection);
  }
  return box;
}
#endif

ProbeHit projectImpostor(ProbeShape probe, vec3 position, vec3 normal, vec3 reflection)
{
  ProbeHit box = projectBox(probe, position, normal, reflection);
  if (!(box.distance > 1.0e-30f) || box.distance > 1.0e30f) { return box; }
#if BP_MARCH > 0
  if (probe.parameters.steps > 3.5f) { return impostorMarched(probe, position, reflection, box); }
#endif
#if BP_MARCH < 2
  return impostorRefined(probe, position, reflection, box);
#else
  return box;
#endif
}
