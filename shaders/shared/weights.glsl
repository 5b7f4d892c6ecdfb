// How much of a pixel a probe gets. C1-smooth, independent of the order of the probes.

// 0 at the face, 1 at `blend` and further in, 0 outside. A blend distance of 0 is a step.
float faceWeight(float distanceInside, float blend)
{
  float x = distanceInside >= blend ? 1.0f : (distanceInside > 0.0f ? distanceInside / blend : 0.0f);
  x = distanceInside < 0.0f ? 0.0f : x;
  return x * x * (3.0f - 2.0f * x);
}

// Product over the six faces of the influence box. All in the same frame.
float influenceWeight(vec3 position, vec3 influenceMin, vec3 influenceMax, vec3 blendMin, vec3 blendMax)
{
  return faceWeight(position.x - influenceMin.x, blendMin.x) * faceWeight(influenceMax.x - position.x, blendMax.x) *
         faceWeight(position.y - influenceMin.y, blendMin.y) * faceWeight(influenceMax.y - position.y, blendMax.y) *
         faceWeight(position.z - influenceMin.z, blendMin.z) * faceWeight(influenceMax.z - position.z, blendMax.z);
}

// Probes of equal importance share what the more important ones left: each gets remaining * weight * this.
float groupScale(float weightSum)
{
  return 1.0f / max(weightSum, 1.0f);
}

// What a group leaves for the next one, in the end for the sky.
float remainingAfter(float remaining, float weightSum)
{
  return remaining * (1.0f - min(weightSum, 1.0f));
}
