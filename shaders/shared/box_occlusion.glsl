// Box occlusion: darkens reflections of near surfaces, as in the corner of a room. An artistic control that makes no
// picture more accurate. With d the distance along R to the hit: o = saturate(multiplier d^power), factor = mix(1, o,
// strength).
float boxOcclusion(float hitDistance, float multiplier, float power, float strength)
{
  // d^power by logarithms, clamped far beyond visible factors: a power of 0 gives 1, and nothing overflows.
  float raised = hitDistance > 0.0f ? exp2(clamp(power * log2(hitDistance), -100.0f, 100.0f)) : (power > 0.0f ? 0.0f : 1.0f);
  float open = clamp(multiplier * raised, 0.0f, 1.0f);
  return 1.0f + strength * (open - 1.0f);
}
