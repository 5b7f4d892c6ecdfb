// How light falls off as KHR_lights_punctual recommends. A vtkLight carries in its attenuation values (1 / range^4 or 0, the
// linear and the quadratic coefficient), in its exponent the cosine of the inner cone.
float bpDistanceFalloff(vec3 attenuation, float distance)
{
  float share = distance * distance;
  share = share * share * attenuation.x;
  return clamp(1.0f - share, 0.0f, 1.0f) / (attenuation.y * distance + attenuation.z * distance * distance);
}

float bpConeFalloff(float cosine, float outerDegrees, float cosineInner)
{
  float cosineOuter = cos(radians(outerDegrees));
  float within = clamp((cosine - cosineOuter) / max(cosineInner - cosineOuter, 0.001f), 0.0f, 1.0f);
  return within * within;
}
