// Lamps of the draw's probes, drawn as shapes (shared/lamp.glsl): relative to the eye, world axes. Needs gpu/probe_shares.glsl.
uniform int bpLampCount;
uniform float bpLampsWhole;             // 1 in a first capture, whose direct light no box divides, else 0: all is in slot 0 then
layout(std140) uniform bpLampBlock      // filters/vtk/draw/lamp_block.h
{
  vec4 bpLampCorner[BP_LAMPS * 8];
  vec4 bpLampMiddle[BP_LAMPS];          // w: its corners, and 16 more if both sides shine
  vec4 bpLampPlane[BP_LAMPS];
  vec4 bpLampLight[BP_LAMPS];           // radiance
  vec4 bpLampGlossy[BP_LAMPS];          // radiance, less what the maps without lamps have in its place
  vec4 bpLampOf[BP_LAMPS];              // 1 for each of the draw's probes whose lamp it is
  vec4 bpLampChannel[BP_LAMPS];         // in each of them, where its visibility stands: gpu/sight.glsl
};

int lampShape(int lamp)
{
  return int(bpLampMiddle[lamp].w);
}

int lampCornerCount(int lamp)
{
  int shape = lampShape(lamp);
  return shape < 16 ? shape : shape - 16;
}

vec3 lampCorner(int lamp, int i)
{
  return bpLampCorner[8 * lamp + i].xyz;
}

vec3 lampMiddle(int lamp)
{
  return bpLampMiddle[lamp].xyz;
}

vec4 lampPlane(int lamp)
{
  return bpLampPlane[lamp];
}

bool lampShinesBothSides(int lamp)
{
  return lampShape(lamp) >= 16;
}

uniform vec4 bpLampLit;                 // 1 for each of the probes whose diffuse light is lamps'
#if BP_LAMP_LOBES
uniform float bpLampColors;             // 1 if the lamps are of several
uniform int bpLobeCount;                // of the lamps in reflections: all, or 0 in captures, which show lamps as maps do
#endif

//BP::LampLight

// The factor of all of a lamp's light here, diffuse and glossy alike: what the probes whose lamp it is have of the pixel, by their `shares`,
// and what is seen of it from here. After bpShareOut and bpFindSights.
float bpLampWeight(int lamp, vec4 shares)
{
  float sum = 0.0f;
  float whole = 0.0f;
  for (int slot = 0; slot < BP_SLOTS; ++slot)
  {
    float seen = bpLampOf[lamp][slot];
#if BP_SIGHTS
    seen *= bpSeen(slot, bpLampChannel[lamp][slot]);
#endif
    sum += shares[slot] * seen;
    whole = max(whole, seen);
  }
  return bpLampsWhole > 0.5f ? whole : sum;
}

// A bit for each lamp that shines on the pixel. Loops over these end where no pixel has lamps left; the end of a loop is asked for last,
// because software renderers work a turn out before they leave it.
int bpLampsHere;

// After bpShareOut and bpFindSights; before the lamps' light.
void bpFindLamps(vec3 position)
{
  vec4 shares = vec4(0.0f);
  for (int slot = 0; slot < BP_SLOTS; ++slot) { shares[slot] = bpShareOf[slot]; }
  bpLampsHere = 0;
  int lamp = 0;
  do
  {
    bool shines = lampSide(lamp, position) != 0.0f && bpLampWeight(lamp, shares) > 0.0f;
    bpLampsHere += shines ? 1 << lamp : 0;
    ++lamp;
  } while (lamp < bpLampCount);
}

// The lamp of the lowest bit.
int bpFirstLamp(int lamps)
{
  return int(log2(float(lamps & -lamps)) + 0.5f);
}

#if BP_LAMP_SHAPES
vec3 bpLampsIrradiance(vec3 position, vec3 normal)
{
  vec4 shares = vec4(0.0f);
  for (int slot = 0; slot < BP_SLOTS; ++slot) { shares[slot] = bpShareOf[slot] * bpIntensity[slot]; }
  shares *= bpLampLit;
  vec3 sum = vec3(0.0f);
  int left = bpLampsHere;
  if (left != 0)
  {
    do
    {
      int lamp = bpFirstLamp(left);
      sum += bpLampWeight(lamp, shares) * lampDiffuse(lamp, position, normal) * bpLampLight[lamp].rgb;
      left &= left - 1;
    } while (left != 0);
  }
  return sum;
}
#endif

#if BP_LAMP_LOBES
// Reflected by F0, and by what a surface reflects at a flat angle; and what the map shows of them.
// What the map has in a lamp's place is subtracted from the F0 term only: in the F90 term the map's light counts by the mean of the lobe.
void bpAddLamps(inout BpLight light, vec3 position, vec3 normal, vec3 view, float roughness)
{
  vec4 shares = vec4(0.0f);
  for (int slot = 0; slot < BP_SLOTS; ++slot) { shares[slot] = bpShareOf[slot] * bpIntensity[slot] * bpLampFree[slot]; }
  float byShape = lampsByShape(roughness);
  LampLobe lobe = lampLobe(normal, view, roughness);
  int left = bpLobeCount > 0 && (byShape > 0.0f || bpLampColors > 0.5f) ? bpLampsHere : 0;
  if (left != 0)
  {
    int close = 0;  // too near for a glance
    do
    {
      int lamp = bpFirstLamp(left);
      float weight = bpLampWeight(lamp, shares);
      LampGlance glance = lampGlossyGlance(lamp, position, lobe);
      bool waits = glance.tooNear && weight > 0.0f;
      close += waits ? 1 << lamp : 0;
      vec2 lit = waits ? vec2(0.0f) : weight * glance.light;
      light.lampsF0 += lit.x * bpLampGlossy[lamp].rgb;
      light.lampsF90 += lit.y * bpLampLight[lamp].rgb;
      left &= left - 1;
    } while (left != 0);
    if (close != 0)
    {
      do
      {
        int lamp = bpFirstLamp(close);
        vec2 lit = bpLampWeight(lamp, shares) * lampGlossyNear(lamp, position, lobe);
        light.lampsF0 += lit.x * bpLampGlossy[lamp].rgb;
        light.lampsF90 += lit.y * bpLampLight[lamp].rgb;
        close &= close - 1;
      } while (close != 0);
    }
  }
  light.specular += (1.0f - byShape) * light.lampsInMap * lampColor(light.lampsF0, bpLampGlossy[0].rgb);
  light.lampsF0 *= byShape;
  light.lampsF90 *= byShape;
}

// The lamps' reflection over what the surface reflects at all: beside the mean light of its lobe, which techniques find.
vec3 bpLampsMean(BpLight light, vec3 f0, vec3 f90, vec2 splitSum)
{
  return (f0 * light.lampsF0 + f90 * light.lampsF90) / max(f0 * splitSum.x + f90 * splitSum.y, vec3(1.0e-6f));
}
#endif
