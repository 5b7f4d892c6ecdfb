// How a pixel leaves VTK's PBR shader: linear scene units into captures and EXR files, display colours on the screen.
//   BP_QUICK_OUTPUT   defined if display colours may be off by a twentieth of an 8-bit step
vec3 bpDisplayed(vec3 light)
{
#ifdef BP_QUICK_OUTPUT
  // light^(1 / 2.2) on [0, 1] to 2.0e-4, by the sum of these powers whose greatest error is least: roots cost less than a logarithm and
  // a power. Beyond 1 it stays beyond 1; what is infinite must not become infinity less infinity.
  vec3 x = min(light, vec3(16.0f));
  vec3 s = sqrt(x);
  vec3 q = sqrt(s);
  return s * (1.3511403f + 0.5856131f * s - q * (0.7718407f + 0.1882785f * s)) + 0.0233659f * q;
#else
  return pow(light, vec3(1.0f / 2.2f));
#endif
}

vec3 bpOutput(vec3 color)
{
  return bpExposure >= 0.0f ? bpDisplayed(color * bpExposure) : color;
}

// VTK 9.1 takes the eye for a point even under parallel projection.
vec3 bpViewVector(vec3 positionView)
{
  return bpParallel > 0.5f ? vec3(0.0f, 0.0f, 1.0f) : normalize(-positionView);
}
