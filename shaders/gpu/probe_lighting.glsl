// What the probes and the sky add to a pixel of VTK's PBR shader. Spliced in by filters/vtk/surface/probe_source.cpp, which defines
//   BP_SLOTS     probes this draw may use (0 to 4), most important first
//   BP_GROUPS    runs of equal importance among them
//   BP_BEVEL     defined if any of their boxes has rounded edges
//   BP_OCCLUSION 1 if any of them is darkened by distance
//   BP_ROTATED   1 if any of their boxes is rotated
//   BP_WEIGHTS   0 if the draw lies where its one probe has full weight
//   BP_CONSTANT_SHARES 1 if each probe has the same share of every pixel, worked out by the host
//   BP_ONLY_PROBES 1 if what the probes leave to the sky goes to them, wherever one has weight
//   BP_SKY       0 if the probes leave nothing to the sky anywhere in the draw
//   BP_DEBUG     1 in the debug view's programs, which note what the lookups were
//   BP_SAMPLED   1 if what techniques sample is kept apart, to be smoothed
//   BP_MIRROR    defined if the surface is a planar mirror with a picture of what moves
//   BP_ANISOTROPIC defined if the surface is brushed: light from all around is that of bpUnbentNormal, not of the lookup's normal
//   BP_FLAT_MAPS defined if maps are flat pictures (gpu/flat_lookup.glsl), else they are cubemaps
//   BP_LATTICE   1 if diffuse light of some of them is a lattice's
//   BP_LAMP_SHAPES 1 if, with that, it is of lamps drawn as shapes
//   BP_LAMP_LOBES 1 if reflections of some of them show lamps by their shapes
//   BP_SIGHTS    1 if some of their lamps or light sources are hidden from some places (gpu/sight.glsl)
//   BP_OPENNESS  1 if what stands in the scene hides some of the sky (gpu/sky_openness.glsl)
//   BP_DIFFUSE   0 if the material is all metal, which has no use for irradiance
// and puts, at the marks below, gpu/probe_slot.glsl and gpu/probe_weight.glsl once for each slot.
// Everything is relative to the camera: the host subtracts in double, so a scene far from the origin looks the same.

uniform mat3 bpViewToWorld;
uniform ivec2 bpPixelOrigin;    // where in the picture the framebuffer's lower left lies
uniform int bpFrame;            // of those that are averaged, from 0
uniform float bpParallel;       // 1 under parallel projection
uniform float bpExposure;       // negative: linear output; else display colours at this exposure
#ifdef BP_FLAT_MAPS
#define PROBE_MAP sampler2D
// The last level of a chain has 4 texels along a face.
#define BP_SKY_LOOKUP(direction, level) bpFlatLookup(bpSkyMap, direction, level, 4.0f * exp2(bpSkyMaxLevel), bpSkyMaxLevel)
#define BP_SLOT_LOOKUP(map, slot, direction, level) bpFlatLookup(map, direction, level, 4.0f * exp2(bpMaxLevel[slot]), bpMaxLevel[slot])
#else
#define PROBE_MAP samplerCube
#define BP_SKY_LOOKUP(direction, level) textureLod(bpSkyMap, direction, level)
#define BP_SLOT_LOOKUP(map, slot, direction, level) textureLod(map, direction, level)
#endif
uniform PROBE_MAP bpSkyMap;     // prefiltered sky
uniform float bpSkyMaxLevel;
uniform float bpSkyIntensity;   // 0: the sky gives nothing
uniform vec3 bpSkySh[9];

#if BP_SLOTS > 0
uniform vec3 bpOrigin[BP_SLOTS];        // capture origin minus camera position, world axes
uniform vec3 bpBoxMin[BP_SLOTS];        // projection box, probe frame
uniform vec3 bpBoxMax[BP_SLOTS];
uniform vec3 bpInfluenceMin[BP_SLOTS];  // influence box, probe frame
uniform vec3 bpInfluenceMax[BP_SLOTS];
uniform vec3 bpRateMin[BP_SLOTS];        // 1 / blend distance
uniform vec3 bpRateMax[BP_SLOTS];
uniform float bpIntensity[BP_SLOTS];
uniform float bpMaxLevel[BP_SLOTS];
uniform vec3 bpSh[9 * BP_SLOTS];
#ifdef BP_BEVEL
uniform vec2 bpBevel[BP_SLOTS];          // radius of the box's edges, scene units: x + y * roughness
#endif
#if BP_CONSTANT_SHARES
uniform float bpShare[BP_SLOTS];
uniform float bpSkyShare;
#endif
#if BP_OCCLUSION
uniform vec3 bpOcclusion[BP_SLOTS];      // multiplier, power, strength
#endif
#if BP_ROTATED
uniform mat3 bpWorldFromProbe[BP_SLOTS];
uniform mat3 bpMapFromProbe[BP_SLOTS];   // to the axes the maps were captured along
#endif
#if BP_DEBUG
uniform vec3 bpProbeColor[BP_SLOTS];
uniform float bpDistanceFaceSize[BP_SLOTS]; // 0: no distances
#endif
#endif

#ifdef BP_ANISOTROPIC
#define BP_FACING bpFacing
#else
#define BP_FACING normal
#endif

struct BpLight
{
  vec3 specular;
  vec3 irradiance;
#if BP_SAMPLED
  vec3 sampled;  // of `specular`: what is to be smoothed
#endif
#if BP_LAMP_LOBES
  vec3 lampsF0;  // of lamps as shapes, beside `specular`: F0 times this
  vec3 lampsF90; // plus F90 times this is reflected
  float lampsInMap; // what the map shows of them, mean of the colours
#endif
#ifdef BP_MIRROR
  float share;   // that `specular` was multiplied by: what moves before the mirror is, too
#endif
};

//BP::Distances

//BP::Lattice

//BP::LampFree

//BP::Slots

//BP::ShareOut

//BP::Sights

//BP::Lamps

//BP::Openness

BpLight bpGatherLight(vec3 positionView, vec3 normalView, vec3 viewView, float roughness, float fresnel,
                      float f0)
{
  vec3 position = finiteOr(bpViewToWorld * positionView, vec3(0.0f));
  vec3 view = directionOr(bpViewToWorld * viewView, vec3(0.0f, 0.0f, 1.0f));
  vec3 normal = directionOr(bpViewToWorld * normalView, view);
  vec3 reflection = reflectedView(normal, view);
  roughness = roughnessWithin(roughness);
#ifdef BP_ANISOTROPIC
  bpFacing = directionOr(bpViewToWorld * bpUnbentNormal, normal);
#endif

  BpLight light;
  light.specular = vec3(0.0f);
  light.irradiance = vec3(0.0f);
#if BP_SAMPLED
  light.sampled = vec3(0.0f);
#endif
#if BP_LAMP_LOBES
  light.lampsF0 = vec3(0.0f);
  light.lampsF90 = vec3(0.0f);
  light.lampsInMap = 0.0f;
#endif
#ifdef BP_MIRROR
  light.share = 0.0f;
#endif
#if BP_DEBUG
  if (!bpCoat) { bpTraceNothing(); }
#endif

  float remaining = bpShareOut(position);
#if BP_SIGHTS
  bpFindSights(position, BP_FACING);
#endif
//BP::AddSlots
#if BP_LAMP_SHAPES || BP_LAMP_LOBES
  bpFindLamps(position);
#endif
#if BP_LAMP_SHAPES
  light.irradiance += bpLampsIrradiance(position, BP_FACING);
#endif
#if BP_LAMP_LOBES
  bpAddLamps(light, position, normal, view, roughness);
#endif

#if BP_SKY
  float sky = remaining * bpSkyIntensity;
  if (sky > 1.0e-5f)
  {
#if BP_DEBUG
    bpLookups += 1.0f;
    bpWeightColor += bpCoat ? vec3(0.0f) : sky * bpSkyColor;
#endif
#if BP_OPENNESS
    float open = bpOpenness(position, BP_FACING);
    light.specular += sky * reflectedOpenness(open, dot(normal, view), roughness) *
                      BP_SKY_LOOKUP(reflection, levelForRoughness(roughness, bpSkyMaxLevel)).rgb;
    sky *= open;
#else
    light.specular += sky * BP_SKY_LOOKUP(reflection, levelForRoughness(roughness, bpSkyMaxLevel)).rgb;
#endif
#if BP_DIFFUSE
    light.irradiance += sky * shIrradiance(BP_FACING, bpSkySh[0], bpSkySh[1], bpSkySh[2], bpSkySh[3], bpSkySh[4],
                                           bpSkySh[5], bpSkySh[6], bpSkySh[7], bpSkySh[8]);
#endif
  }
#endif
#ifdef BP_MIRROR
  if (bpMirrorOn > 0.5f)
  {
    // Over what stands still, by its coverage; premultiplied, so that edges have no fringe.
    vec4 moving = mirroredLight(bpMirrorLook(), position, normal, view, roughness);
    light.specular = (1.0f - moving.w) * light.specular + (light.share + remaining) * vec3(moving);
#if BP_LAMP_LOBES
    light.lampsF0 = (1.0f - moving.w) * light.lampsF0;
    light.lampsF90 = (1.0f - moving.w) * light.lampsF90;
#endif
#if BP_DEBUG
    bpLookups += float(mirrorFetches(bpMirrorLook(), position, normal, view, roughness));
#endif
#if BP_SAMPLED
    light.sampled = (1.0f - moving.w) * light.sampled;
#endif
  }
#endif
#if BP_DEBUG
#if BP_DIFFUSE
  if (!bpCoat) { bpDiffuseLight = light.irradiance; }
#endif
  bpCoat = true;  // the next call, if there is one, is for the clear coat
#endif
  return light;
}
