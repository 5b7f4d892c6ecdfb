// `fetchDistance` on the GPU. Debug view only.
float fetchDistance(samplerCube map, ProbeShape probe, vec3 direction)
{
  return textureLod(map, direction, 0.0f).r;
}
