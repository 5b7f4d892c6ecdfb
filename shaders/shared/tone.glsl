// Tone mapping: scene light to light on a display whose white is 1, before its transfer curve. Colours are linear, of sRGB's primaries.

// What no curve may be asked about: infinite light would become infinity over infinity.
vec3 toneInput(vec3 light)
{
  return clamp(light, vec3(0.0f), vec3(65504.0f));
}

// Khronos PBR Neutral Tone Mapper (Khronos 3D Commerce, specification of 2024): base colours up to 0.8 less the 0.04 of a dielectric's
// reflection come out as they went in; only what is brighter is compressed, towards white.
vec3 toneNeutral(vec3 light)
{
  const float kStart = 0.76f;  // 0.8 - 0.04
  const float kRange = 0.24f;  // 1 - kStart
  vec3 c = toneInput(light);
  float least = min(c.x, min(c.y, c.z));
  c = c - vec3(least < 0.08f ? least - 6.25f * least * least : 0.04f);
  float peak = max(c.x, max(c.y, c.z));
  float shown = 1.0f - kRange * kRange / max(peak + kRange - kStart, 0.001f);
  float white = 1.0f - 1.0f / (0.15f * (peak - shown) + 1.0f);
  vec3 compressed = mix(c * (shown / max(peak, 1.0e-6f)), vec3(shown), white);
  return peak < kStart ? c : compressed;
}

// AgX (Sobotka 2022) in Rec. 2020's primaries, as Blender and Filament have it; the curve between log2 -12.47393 and 4.026069 is
// Wrensch's polynomial of 2023. The inset's matrix stands multiplied with that from sRGB's primaries.
vec3 toneAgx(vec3 light)
{
  const mat3 kInset = mat3(0.54481208f, 0.14041935f, 0.08881714f, 0.37379744f, 0.75410778f, 0.17885976f, 0.08138096f, 0.10539675f, 0.73231543f);
  const mat3 kOutset = mat3(1.12710058f, -0.14132976f, -0.14132976f, -0.11060664f, 1.15782370f, -0.11060664f, -0.01649394f, -0.01649394f, 1.25193641f);
  const mat3 kFromRec2020 = mat3(1.6605f, -0.1246f, -0.0182f, -0.5876f, 1.1329f, -0.1006f, -0.0728f, -0.0083f, 1.1187f);
  vec3 x = clamp((log2(max(kInset * toneInput(light), vec3(1.0e-10f))) + vec3(12.47393f)) / 16.499999f, vec3(0.0f), vec3(1.0f));
  vec3 shown = (((((15.5f * x - 40.14f) * x + 31.96f) * x - 6.868f) * x + 0.4298f) * x + 0.1191f) * x - 0.00232f;
  return clamp(kFromRec2020 * pow(max(kOutset * shown, vec3(0.0f)), vec3(2.2f)), vec3(0.0f), vec3(1.0f));
}

// The Academy's reference rendering for an sRGB display, by Hill's fit (2016) of its curve between two changes of primaries. Light is
// divided by 0.6 first, so that a middle grey remains one.
vec3 toneAces(vec3 light)
{
  const mat3 kInto = mat3(0.59719f, 0.07600f, 0.02840f, 0.35458f, 0.90834f, 0.13383f, 0.04823f, 0.01566f, 0.83777f);
  const mat3 kBack = mat3(1.60475f, -0.10208f, -0.00327f, -0.53108f, 1.10813f, -0.07276f, -0.07367f, -0.00605f, 1.07602f);
  vec3 v = kInto * (toneInput(light) / 0.6f);
  vec3 curve = (v * (v + vec3(0.0245786f)) - vec3(0.000090537f)) / (v * (0.983729f * v + vec3(0.4329510f)) + vec3(0.238081f));
  return clamp(kBack * curve, vec3(0.0f), vec3(1.0f));
}
