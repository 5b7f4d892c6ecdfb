// How a pixel leaves VTK's PBR shader: linear scene units into captures and EXR files, display colours on the screen.
vec3 bpOutput(vec3 color)
{
  return bpExposure >= 0.0f ? pow(color * bpExposure, vec3(1.0f / 2.2f)) : color;
}

// VTK 9.1 takes the eye for a point even under parallel projection.
vec3 bpViewVector(vec3 positionView)
{
  return bpParallel > 0.5f ? vec3(0.0f, 0.0f, 1.0f) : normalize(-positionView);
}
