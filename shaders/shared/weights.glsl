// The weight of a probe in a pixel. C1-smooth, independent of the order of the probes.

// 0 at the face and outside, 1 from 1 / `rate` inwards.
float faceWeight(float distanceInside, float rate)
{
  float x = clamp(distanceInside * rate, 0.0f, 1.0f);
  return x * x * (3.0f - 2.0f * x);
}

// Product over the six faces of the influence box, all in the same frame. Rates are 1 / blend distance; the host
// converts a blend distance of 0 to a rate so high that the transition is narrower than a position's rounding error
// (filters/core/geometry/probe_geometry).
float influenceWeight(vec3 position, vec3 influenceMin, vec3 influenceMax, vec3 rateMin, vec3 rateMax)
{
  return faceWeight(position.x - influenceMin.x, rateMin.x) * faceWeight(influenceMax.x - position.x, rateMax.x) *
         faceWeight(position.y - influenceMin.y, rateMin.y) * faceWeight(influenceMax.y - position.y, rateMax.y) *
         faceWeight(position.z - influenceMin.z, rateMin.z) * faceWeight(influenceMax.z - position.z, rateMax.z);
}

// Probes of equal importance share what more important ones leave: each gets remaining * weight * this. For weight sums
// of at least 1 they are divided by it, so that they share everything; below, 1 + s - s² has the same slope at 1, where
// plain weights would show a crease. A group's total is s (1 + s - s²), which is 1 with zero slope at s = 1.
float groupScale(float weightSum)
{
  return weightSum < 1.0f ? 1.0f + weightSum * (1.0f - weightSum) : 1.0f / max(weightSum, 1.0f);
}

// What a group leaves to the next one, and finally to the sky.
float remainingAfter(float remaining, float weightSum)
{
  float s = clamp(weightSum, 0.0f, 1.0f);
  return remaining * max(1.0f - s * (1.0f + s * (1.0f - s)), 0.0f);
}

// Share of the pixel per unit of weight for a group of probes of equal importance.
float groupShare(float remaining, float weightSum)
{
  return remaining * groupScale(weightSum);
}

// If probes leave nothing to the sky, their shares are scaled by this factor to sum to 1. Below the limit no probe
// counts as having weight, because the quotient would be noise.
float onlyProbesScale(float remaining)
{
  float given = 1.0f - remaining;
  return given > 1.0e-4f ? 1.0f / given : 1.0f;
}

// What they still leave: everything where no probe has weight, else nothing.
float onlyProbesRemaining(float remaining)
{
  return 1.0f - remaining > 1.0e-4f ? 0.0f : remaining;
}
