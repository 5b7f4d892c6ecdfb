// A surface in a browser (WebGL2): what VTK's shader with this program's splice draws, after a technique's pieces
// (filters/io/engines/technique_text.h) and shared/weights, fresnel, split_sum, sh, light_falloff and display. Written for data/web/room.js,
// which defines
//   BP_TONE   the scene's tone curve, or nothing
//   BP_UNLIT, BP_BASE_MAP, BP_ROUGHNESS_MAP, BP_EMISSIVE_MAP   of the material
//   BP_SLOTS, BP_GROUPS   probes of the object, most important first, and runs of equal importance; bpGroupOf where BP_SLOTS > 0
//   BP_ONLY_PROBES, BP_SKY, BP_LIGHTS, BP_MULTIPLE, BP_BRDF_SIZE
// World space, scene units. The terms and clamps of direct light are those of filters/core/surface/direct_light.cpp.
uniform vec3 bpEye;
uniform float bpExposure;            // negative: linear output
uniform vec4 bpBaseColor;
uniform vec3 bpEmissive;
uniform vec3 bpMetalRoughF0;         // metallic, perceptual roughness, reflectance of the non-metal
uniform float bpAlphaCutoff;
uniform sampler2D bpSplitSumMap;
#ifdef BP_BASE_MAP
uniform sampler2D bpBaseMap;
uniform mat3 bpBaseFromUv;
#endif
#ifdef BP_ROUGHNESS_MAP
uniform sampler2D bpRoughnessMap;
uniform mat3 bpRoughnessFromUv;
#endif
#ifdef BP_EMISSIVE_MAP
uniform sampler2D bpEmissiveMap;
uniform mat3 bpEmissiveFromUv;
#endif
#if BP_LIGHTS > 0
uniform vec4 bpLightDirection[BP_LIGHTS];  // the way it travels; w: 0 directional, 1 point, 2 spot
uniform vec4 bpLightPosition[BP_LIGHTS];   // w: 1 / range
uniform vec3 bpLightRadiance[BP_LIGHTS];
uniform vec2 bpLightCosines[BP_LIGHTS];    // outer, inner
#endif
#if BP_SKY
uniform samplerCube bpSkyMap;
uniform float bpSkyMaxLevel;
uniform vec3 bpSkySh[9];
#endif
#if BP_SLOTS > 0
uniform BoxprobeProbe bpProbe[BP_SLOTS];
uniform vec3 bpInfluenceMin[BP_SLOTS];
uniform vec3 bpInfluenceMax[BP_SLOTS];
uniform vec3 bpRateMin[BP_SLOTS];
uniform vec3 bpRateMax[BP_SLOTS];
uniform float bpOpen[BP_SLOTS];  // 1: the sky shows where the probe saw nothing
uniform vec3 bpSh[9 * BP_SLOTS];
uniform samplerCube bpMap0;
#endif
#if BP_SLOTS > 1
uniform samplerCube bpMap1;
#endif
#if BP_SLOTS > 2
uniform samplerCube bpMap2;
#endif
#if BP_SLOTS > 3
uniform samplerCube bpMap3;
#endif

in vec3 bpPosition;
in vec3 bpNormal;
in vec2 bpUv;
out vec4 bpColor;

vec4 bpShown(vec3 color)
{
  return vec4(bpExposure >= 0.0f ? srgbEncoded(BP_TONE(max(color, vec3(0.0f)) * bpExposure)) : color, 1.0f);
}

// What is cut out ends here.
vec4 bpBase()
{
  vec4 base = bpBaseColor;
#ifdef BP_BASE_MAP
  base *= texture(bpBaseMap, (bpBaseFromUv * vec3(bpUv, 1.0f)).xy);
#endif
  if (base.a < bpAlphaCutoff) { discard; }
  return base;
}

#ifdef BP_UNLIT
void main()
{
  vec4 base = bpBase();
  bpColor = bpShown(base.rgb);
}
#else
float bpCosine(vec3 a, vec3 b) { return clamp(dot(a, b), 1.0e-5f, 1.0f); }

// Unit irradiance from `l`, diffuse and specular, with the cosine.
vec3 bpDirect(vec3 n, vec3 v, vec3 l, float roughness, float metallic, vec3 albedo, vec3 f0, vec3 f90, vec3 scattering)
{
  vec3 h = normalize(v + l);
  float nDotV = bpCosine(n, v);
  float nDotL = bpCosine(n, l);
  float nDotH = bpCosine(n, h);
  float a2 = roughness * roughness * roughness * roughness;
  float d = max((nDotH * a2 - nDotH) * nDotH + 1.0f, max(a2, 1.0e-12f));
  float distribution = a2 / (3.14159265f * d * d);
  float masking = 0.5f / (nDotL * sqrt(a2 + nDotV * (nDotV - a2 * nDotV)) + nDotV * sqrt(a2 + nDotL * (nDotL - a2 * nDotL)));
  vec3 fresnel = schlickFresnel(f0, f90, bpCosine(h, l));
  vec3 diffuse = (1.0f - metallic) * (1.0f - fresnel) * albedo * 0.31830989f;
  return (diffuse + scattering * distribution * masking * fresnel) * nDotL;
}

#if BP_SLOTS > 0
void bpAdd(inout vec3 specular, inout vec3 irradiance, vec4 reflected, vec3 skyLight, int slot, float share, vec3 normal)
{
  float intensity = bpProbe[slot].bevelAndIntensity.z;
  specular += share * (reflected.rgb + bpOpen[slot] * intensity * clamp(1.0f - reflected.a, 0.0f, 1.0f) * skyLight);
  irradiance += share * intensity *
    shIrradiance(normal, bpSh[9 * slot], bpSh[9 * slot + 1], bpSh[9 * slot + 2], bpSh[9 * slot + 3], bpSh[9 * slot + 4],
                 bpSh[9 * slot + 5], bpSh[9 * slot + 6], bpSh[9 * slot + 7], bpSh[9 * slot + 8]);
}
#endif

void main()
{
  vec4 base = bpBase();
  vec3 emissive = bpEmissive;
#ifdef BP_EMISSIVE_MAP
  emissive *= texture(bpEmissiveMap, (bpEmissiveFromUv * vec3(bpUv, 1.0f)).xy).rgb;
#endif
  float metallic = bpMetalRoughF0.x;
  float roughness = bpMetalRoughF0.y;
#ifdef BP_ROUGHNESS_MAP
  vec4 packed = texture(bpRoughnessMap, (bpRoughnessFromUv * vec3(bpUv, 1.0f)).xy);
  metallic *= packed.b;
  roughness *= packed.g;
#endif
  roughness = roughnessWithin(roughness);
  vec3 albedo = base.rgb;
  vec3 view = normalize(bpEye - bpPosition);
  vec3 normal = normalize(directionOr(bpNormal, view));
  if (gl_FrontFacing == false) { normal = -normal; }
  vec3 reflection = reflectedView(normal, view);
  float cosine = bpCosine(normal, view);
  vec3 f0 = mix(vec3(bpMetalRoughF0.z), albedo, metallic);
  vec3 f90 = mix(vec3(clamp(dot(f0, vec3(16.5f)), 0.0f, 1.0f)), vec3(1.0f), metallic);
  vec2 splitSum = texture(bpSplitSumMap, splitSumPlace(cosine, roughness, BP_BRDF_SIZE)).rg;
  vec3 scattering = vec3(1.0f);
#ifdef BP_MULTIPLE
  scattering = multipleScattering(f0, splitSum);
#endif

  vec3 specular = vec3(0.0f);
  vec3 irradiance = vec3(0.0f);
  vec3 skyLight = vec3(0.0f);
#if BP_SKY
  skyLight = textureLod(bpSkyMap, lookupDirection(reflection), levelForRoughness(roughness, bpSkyMaxLevel)).rgb;
#endif
  float remaining = 1.0f;
#if BP_SLOTS > 0
  float weight[BP_SLOTS];
  float groupSum[BP_GROUPS];
  float share[BP_GROUPS];
  for (int g = 0; g < BP_GROUPS; ++g) { groupSum[g] = 0.0f; }
  for (int i = 0; i < BP_SLOTS; ++i)
  {
    vec3 local = boxprobeTurned(bpProbe[i], bpPosition - bpProbe[i].origin);
    weight[i] = influenceWeight(local, bpInfluenceMin[i], bpInfluenceMax[i], bpRateMin[i], bpRateMax[i]);
    groupSum[bpGroupOf[i]] += weight[i];
  }
  for (int g = 0; g < BP_GROUPS; ++g)
  {
    share[g] = groupShare(remaining, groupSum[g]);
    remaining = remainingAfter(remaining, groupSum[g]);
  }
#ifdef BP_ONLY_PROBES
  for (int g = 0; g < BP_GROUPS; ++g) { share[g] *= onlyProbesScale(remaining); }
  remaining = onlyProbesRemaining(remaining);
#endif
#define BP_ADD(slot, map) if (weight[slot] > 0.0f) \
  { bpAdd(specular, irradiance, boxprobeReflectionOf(map, bpProbe[slot], bpPosition, normal, view, roughness, relativeF0(f0, f90)), skyLight, slot, \
          share[bpGroupOf[slot]] * weight[slot], normal); }
  BP_ADD(0, bpMap0)
#if BP_SLOTS > 1
  BP_ADD(1, bpMap1)
#endif
#if BP_SLOTS > 2
  BP_ADD(2, bpMap2)
#endif
#if BP_SLOTS > 3
  BP_ADD(3, bpMap3)
#endif
#endif
#if BP_SKY
  specular += remaining * skyLight;
  irradiance += remaining * shIrradiance(normal, bpSkySh[0], bpSkySh[1], bpSkySh[2], bpSkySh[3], bpSkySh[4], bpSkySh[5],
                                         bpSkySh[6], bpSkySh[7], bpSkySh[8]);
#endif

  vec3 color = emissive + specular * scattering * (f0 * splitSum.x + f90 * splitSum.y) +
    (1.0f - f0) * (1.0f - metallic) * irradiance * albedo;
#if BP_LIGHTS > 0
  for (int i = 0; i < BP_LIGHTS; ++i)
  {
    vec3 radiance = bpLightRadiance[i];
    vec3 l = -bpLightDirection[i].xyz;
    if (bpLightDirection[i].w > 0.5f)
    {
      vec3 to = bpLightPosition[i].xyz - bpPosition;
      float away = length(to);
      l = to / max(away, 1.0e-18f);
      radiance *= distanceFalloff(away, bpLightPosition[i].w);
      if (bpLightDirection[i].w > 1.5f)
      {
        radiance *= coneFalloff(dot(-l, bpLightDirection[i].xyz), bpLightCosines[i].x, bpLightCosines[i].y);
      }
    }
    color += radiance * bpDirect(normal, view, l, roughness, metallic, albedo, f0, f90, scattering);
  }
#endif
  bpColor = bpShown(color);
}
#endif
