// Lamps of the draw's probes, drawn as shapes (shared/lamp.glsl): relative to the eye, world axes. Needs gpu/probe_shares.glsl.
uniform int bpLampCount;                // turns: lamps that turn their backs on one another share one
uniform int bpLampOther[BP_LAMPS];      // of each turn the lamp that counts where the first cannot be seen
uniform vec3 bpLampCorner[BP_LAMPS * 8];
uniform int bpLampShape[BP_LAMPS];      // its corners, and 16 more if both sides shine
uniform vec3 bpLampLight[BP_LAMPS];     // radiance
uniform vec4 bpLampOf[BP_LAMPS];        // 1 for each of the draw's probes whose lamp it is
#if BP_SIGHTS
uniform vec4 bpLampChannel[BP_LAMPS];   // in each of them, where its visibility stands: gpu/sight.glsl
#endif

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

// The factor of all of a lamp's light here: what the probes whose lamp it is have of the pixel, and what is seen of it from here. After
// bpShareOut and bpFindSights.
float bpLampWeight(int lamp)
{
  float sum = 0.0f;
  for (int slot = 0; slot < BP_SLOTS; ++slot)
  {
    float share = bpShareOf[slot] * bpIntensity[slot] * bpLampOf[lamp][slot];
#if BP_SIGHTS
    share *= bpSeen(slot, bpLampChannel[lamp][slot]);
#endif
    sum += share;
  }
  return sum;
}

vec3 bpLampsIrradiance(vec3 position, vec3 normal)
{
  vec3 sum = vec3(0.0f);
  int i = 0;
  // The end is asked for last: software renderers work a turn out before they leave a loop.
  do
  {
    int lamp = lampSide(i, position) != 0.0f ? i : bpLampOther[i];
    sum += bpLampWeight(lamp) * lampDiffuse(lamp, position, normal) * bpLampLight[lamp];
    ++i;
  } while (i < bpLampCount);
  return sum;
}
