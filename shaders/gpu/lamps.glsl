// Lamps of the draw's probes, drawn as shapes (shared/lamp.glsl): relative to the eye, world axes. Needs gpu/probe_shares.glsl.
uniform int bpLampCount;
uniform vec3 bpLampCorner[BP_LAMPS * 8];
uniform int bpLampShape[BP_LAMPS];      // its corners, and 16 more if both sides shine
uniform vec3 bpLampLight[BP_LAMPS];     // radiance
uniform vec4 bpLampOf[BP_LAMPS];        // 1 for each of the draw's probes whose lamp it is

int lampCornerCount(int lamp)
{
  return bpLampShape[lamp] < 16 ? bpLampShape[lamp] : bpLampShape[lamp] - 16;
}

vec3 lampCorner(int lamp, int i)
{
  return bpLampCorner[8 * lamp + i];
}

bool lampShinesBothSides(int lamp)
{
  return bpLampShape[lamp] >= 16;
}

//BP::LampLight

// After bpShareOut.
vec3 bpLampsIrradiance(vec3 position, vec3 normal)
{
  vec3 sum = vec3(0.0f);
  for (int i = 0; i < bpLampCount; ++i)
  {
    float share = 0.0f;
    for (int slot = 0; slot < BP_SLOTS; ++slot) { share += bpShareOf[slot] * bpIntensity[slot] * bpLampOf[i][slot]; }
    sum += share * lampDiffuse(i, position, normal) * bpLampLight[i];
  }
  return sum;
}
