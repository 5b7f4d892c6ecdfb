// How a pixel leaves VTK's PBR shader: linear scene units into captures and EXR files, display colours on the screen. Needs
// shared/display.glsl, and shared/tone.glsl for a tone.
//   BP_TONE           the function that maps scene light to the display's, if any
//   BP_VTK_CURVE      defined if display colours are VTK's: the power 1 / 2.2, where VTK's own pictures stand beside
//   BP_QUICK_OUTPUT   defined if display colours may be off by a fiftieth of an 8-bit step
vec3 bpDisplayed(vec3 light)
{
#ifdef BP_TONE
  light = BP_TONE(light);
#endif
#if defined(BP_VTK_CURVE)
  return pow(light, vec3(1.0f / 2.2f));
#elif defined(BP_QUICK_OUTPUT)
  // The curve's power on [0.0031308, 1] to 3.5e-5, by the sum of these powers whose greatest error is least: roots cost less than a
  // logarithm and a power. Beyond 1 it stays beyond 1; what is infinite must not become infinity less infinity.
  vec3 x = min(light, vec3(16.0f));
  vec3 q = sqrt(sqrt(x));
  vec3 shown = (((0.08133f * q - 0.3355016f) * q + 1.1226816f) * q + 0.1961359f) * q - 0.0646115f;
  return mix(12.92f * x, shown, step(0.0031308f, x));
#else
  return srgbEncoded(light);
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
