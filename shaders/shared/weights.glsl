// How much of a pixel a probe gets. C1-smooth, independent of the order of the probes.

// 0 at the face and outside, 1 from 1 / `rate` inwards.
float faceWeight(float distanceInside, float rate)
{
  float x = clamp(distanceInside * rate, 0.0f, 1.0f);
  return x * x * (3.0f - 2.0f * x);
}

// Product over the six faces of the influence box, all in the same frame. Rates are 1 / blend distance; the host turns a
// blend distance of 0 into a rate so high that the rise is narrower than a position's rounding (filters/core/geometry/probe_geometry).
float influenceWeight(vec3 position, vec3 influenceMin, vec3 influenceMax, vec3 rateMin, vec3 rateMax)
{
  return faceWeight(position.x - influenceMin.x, rateMin.x) * faceWeight(influenceMax.x - position.x, rateMax.x) *
         faceWeight(position.y - influenceMin.y, rateMin.y) * faceWeight(influenceMax.y - position.y, rateMax.y) *
         faceWeight(position.z - influenceMin.z, rateMin.z) * faceWeight(influenceMax.z - position.z, rateMax.z);
}

// Probes of equal importance share what the more important ones left: each gets remaining * weight * this. From a sum of 1
// on they are divided by it, so that they share all there is; below, 1 + s - s^2 meets that with the same slope, where
// plain weights would meet it in a crease. All of a group's weights then give s (1 + s - s^2), which is 1 at 1, flat.
float groupScale(float weightSum)
{
  return weightSum < 1.0f ? 1.0f + weightSum * (1.0f - weightSum) : 1.0f / max(weightSum, 1.0f);
}

// What a group leaves for the next one, in the end for the sky.
float remainingAfter(float remaining, float weightSum)
{
  float s = clamp(weightSum, 0.0f, 1.0f);
  return remaining * max(1.0f - s * (1.0f + s * (1.0f - s)), 0.0f);
}

// Share of the pixel that a group of probes of equal importance gets per unit of weight.
float groupShare(float remaining, float weightSum)
{
  return remaining * groupScale(weightSum);
}

// Where probes leave nothing to the sky, all their shares grow by this factor, so that they sum to 1. Below the limit no
// probe counts as having weight: a division by less would be noise.
float onlyProbesScale(float remaining)
{
  float given = 1.0f - remaining;
  return given > 1.0e-4f ? 1.0f / given : 1.0f;
}

// What they leave all the same: everything where no probe has weight, else nothing.
float onlyProbesRemaining(float remaining)
{
  return 1.0f - remaining > 1.0e-4f ? 0.0f : remaining;
}
