// Material properties beyond metalness and roughness, at a fragment: a tinted reflection, sheen, anisotropy, a thin
// film. Spliced in by filters/vtk/surface/finish_source.cpp, which defines BP_FINISH and, depending on the material,
// BP_TINTED, BP_SHEEN, BP_ANISOTROPIC, BP_FILM; after gpu/material.glsl, with shared/sheen.glsl and the like before it.
#ifdef BP_TINTED
uniform vec3 bpSpecularTint;
uniform float bpSpecularEdge;
#endif
#ifdef BP_SHEEN
uniform vec3 bpSheenColor;
uniform float bpSheenRoughness;
#endif
#ifdef BP_ANISOTROPIC
uniform vec3 bpAnisotropy;  // cosine and sine of the direction from the tangent; strength
#endif
#ifdef BP_FILM
uniform vec4 bpFilm;        // share, index, least and greatest thickness in nanometres
#endif

struct BpFinish
{
  vec3 f0;           // of the non-metal
  float edge;  // its reflectance at grazing angles; BP_TINTED only
  vec3 sheenColor;
  float sheenRoughness;
  float under;  // fraction of light that passes the sheen
  vec3 across;       // view space, unit
  float anisotropy;
  float film;        // share
  float thickness;   // nanometres
};

BpFinish bpFinishAt(vec3 normal, float nDotV)
{
  BpFinish finish;
  finish.f0 = vec3(baseF0Uniform);
  finish.edge = 1.0f;
  finish.sheenColor = vec3(0.0f);
  finish.sheenRoughness = 0.0f;
  finish.under = 1.0f;
  finish.across = vec3(0.0f);
  finish.anisotropy = 0.0f;
  finish.film = 0.0f;
  finish.thickness = 0.0f;
#ifdef BP_TINTED
  finish.edge = bpSpecularEdge BP_SPECULAR_FACTOR;
  finish.f0 = min(finish.f0 * bpSpecularTint BP_SPECULAR_COLOR_FACTOR, vec3(bpSpecularEdge)) BP_SPECULAR_FACTOR;
#endif
#ifdef BP_SHEEN
  finish.sheenColor = bpSheenColor BP_SHEEN_COLOR_FACTOR;
  finish.sheenRoughness = bpSheenRoughness BP_SHEEN_ROUGHNESS_FACTOR;
  finish.under = underSheen(finish.sheenColor, nDotV, finish.sheenRoughness);
#endif
#ifdef BP_ANISOTROPIC
  vec3 along = bpTangentF.xyz - dot(bpTangentF.xyz, normal) * normal;
  float size = length(along);
  vec3 tangent = size > 0.0f ? along / size : vec3(0.0f);
  // The frame of a double-sided surface is reversed on its back.
  vec3 bitangent = cross(normal, tangent) * (bpTangentF.w < 0.0f != gl_FrontFacing ? 1.0f : -1.0f);
  vec2 direction = bpAnisotropy.xy;
  finish.anisotropy = size > 0.0f ? bpAnisotropy.z : 0.0f;
#ifdef BP_HAS_Anisotropy
  vec3 texel = bpSampleAnisotropy().rgb;
  vec2 own = 2.0f * texel.rg - 1.0f;
  float ownSize = length(own);
  own = ownSize > 0.0f ? own / ownSize : vec2(1.0f, 0.0f);
  direction = vec2(direction.x * own.x - direction.y * own.y, direction.x * own.y + direction.y * own.x);
  finish.anisotropy *= texel.b;
#endif
  finish.across = direction.x * bitangent - direction.y * tangent;
#endif
#ifdef BP_FILM
  finish.film = bpFilm.x BP_FILM_FACTOR;
  finish.thickness = mix(bpFilm.z, bpFilm.w, BP_FILM_THICKNESS);
#endif
  return finish;
}

// Reflectance at normal incidence, metal or not.
vec3 bpFinishF0(BpFinish finish, vec3 albedo, float metallic, float nDotV)
{
  vec3 f0 = mix(finish.f0, albedo, metallic);
#ifdef BP_FILM
  vec3 film = filmNormalReflectance(filmReflectance(f0, bpFilm.y, finish.thickness, nDotV), nDotV);
  f0 = mix(f0, film, finish.film);
#endif
  return f0;
}

// Reflectance of a non-metal at grazing angles. `f0` without the film.
float bpFinishEdge(BpFinish finish, vec3 albedo, float metallic)
{
#ifdef BP_TINTED
  return finish.edge;
#else
  return clamp(dot(mix(finish.f0, albedo, metallic), vec3(50.0f * 0.33f)), 0.0f, 1.0f);
#endif
}

#ifdef BP_ANISOTROPIC
// Replaces VTK's lobe of a lamp; `F` is returned as there.
vec3 bpBrushedLobe(BpFinish finish, vec3 N, vec3 V, vec3 L, vec3 H, float hDotL, float roughness, vec3 F0, vec3 F90, out vec3 F)
{
  vec3 along = cross(finish.across, N);
  F = F_Schlick(F0, F90, hDotL);
  vec3 v = vec3(dot(along, V), dot(finish.across, V), clamp(dot(N, V), 1.0e-5f, 1.0f));
  vec3 l = vec3(dot(along, L), dot(finish.across, L), clamp(dot(N, L), 1.0e-5f, 1.0f));
  vec3 h = vec3(dot(along, H), dot(finish.across, H), clamp(dot(N, H), 1.0e-5f, 1.0f));
  return anisotropicLobe(v, l, h, anisotropicAlpha(roughness * roughness, finish.anisotropy)) * F;
}
#endif
