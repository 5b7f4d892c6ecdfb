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

#if BP_LAMP_LOBES
uniform float bpLampColors;             // 1 if they are of several
#endif

//BP::LampLight

// What a lamp's light at a place is multiplied by, diffuse and glossy: of each slot, after bpShareOut, its share.
float bpLampWeight(int lamp, int slot)
{
  return bpShareOf[slot] * bpIntensity[slot] * bpLampOf[lamp][slot];
}

#if BP_LATTICE
vec3 bpLampsIrradiance(vec3 position, vec3 normal)
{
  vec3 sum = vec3(0.0f);
  for (int i = 0; i < bpLampCount; ++i)
  {
    float weight = 0.0f;
    for (int slot = 0; slot < BP_SLOTS; ++slot) { weight += bpLampWeight(i, slot); }
    sum += weight * lampDiffuse(i, position, normal) * bpLampLight[i];
  }
  return sum;
}
#endif

#if BP_LAMP_LOBES
// Reflected by F0, and by what a surface reflects at a flat angle; and what the map shows of them.
void bpAddLamps(inout BpLight light, vec3 position, vec3 normal, vec3 view, float roughness)
{
  float share = lampsByShape(roughness);
  LampLobe lobe = lampLobe(normal, view, roughness);
  int count = share > 0.0f || bpLampColors > 0.5f ? bpLampCount : 0;
  for (int i = 0; i < count; ++i)
  {
    float weight = 0.0f;
    for (int slot = 0; slot < BP_SLOTS; ++slot) { weight += bpLampWeight(i, slot) * bpLampFree[slot]; }
    vec2 lit = weight * lampGlossy(i, position, lobe);
    light.lampsF0 += lit.x * bpLampLight[i];
    light.lampsF90 += lit.y * bpLampLight[i];
  }
  vec3 first = bpLampCount > 0 ? bpLampLight[0] : vec3(1.0f);
  light.specular += (1.0f - share) * light.lampsInMap * lampColor(light.lampsF0 + light.lampsF90, first);
  light.lampsF0 *= share;
  light.lampsF90 *= share;
}

// The lamps' reflection over what the surface reflects at all: beside the mean light of its lobe, which techniques find.
vec3 bpLampsMean(BpLight light, vec3 f0, vec3 f90, vec2 splitSum)
{
  return (f0 * light.lampsF0 + f90 * light.lampsF90) / max(f0 * splitSum.x + f90 * splitSum.y, vec3(1.0e-6f));
}
#endif
