// How light falls off, as KHR_lights_punctual recommends ("Range Property", "Inner and Outer Cone Angles").

// `perRange`: 1 / range, 0 for unlimited lights. Constant below a millionth of a unit, so that a surface at the lamp
// has a finite colour.
float distanceFalloff(float distance, float perRange)
{
  float share = min(distance * perRange, 1.0f);
  share = share * share;
  return (1.0f - share * share) / max(distance * distance, 1.0e-12f);
}

// Cosines to the cone's axis: of the direction, and of the cones.
float coneFalloff(float cosine, float cosineOuter, float cosineInner)
{
  float within = clamp((cosine - cosineOuter) / max(cosineInner - cosineOuter, 0.001f), 0.0f, 1.0f);
  return within * within;
}
