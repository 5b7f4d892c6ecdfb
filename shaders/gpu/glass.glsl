// Glass on the GPU: the ray found by shared/refraction.glsl is sampled from the frame behind the glass
// (gpu/glass_behind.glsl) and, where that shows nothing, like reflections from the object's probes and the sky. Spliced
// in by filters/vtk/surface/material_source.cpp for materials that transmit light, after gpu/probe_lighting.glsl. It
// defines BP_GLASS_FORM (1 to 3, as GlassObject::form), BP_GLASS_SHEET (true or false) and the type GLASS_SHELL.
// Positions are relative to the eye, along the world's axes.
uniform float bpGlassIor;
uniform float bpGlassTransmission;
uniform float bpGlassThickness;
uniform vec3 bpGlassCenter;
uniform float bpGlassRadius;
uniform vec3 bpGlassColor;       // of white light after bpGlassReach
uniform float bpGlassReach;  // 0: no absorption
uniform float bpGlassStraight;  // deviation from which on the frame behind no longer replaces the lookup
uniform float bpGlassBehind;  // share of the frame behind in front faces: two passes blended

#if BP_GLASS_FORM == 3 && !BP_GLASS_SHEET
uniform samplerCube bpGlassShell;
#endif

struct BpGlass
{
  GlassView seen;
  vec3 position;       // for the reflection: bpGatherLight's
  vec3 normal;
  vec3 view;
  float roughness;
  float deviation;
  vec3 transmittance;  // of the transmitted light
  vec3 mirrorTransmittance;
  vec3 looked;  // sampled light along the refracted ray
};

BpGlass bpLookThrough(vec3 positionView, vec3 normalView, vec3 viewView, float roughness)
{
  mat3 viewFromWorld = transpose(bpViewToWorld);
  vec3 position = finiteOr(bpViewToWorld * positionView, vec3(0.0f));
  vec3 view = directionOr(bpViewToWorld * viewView, vec3(0.0f, 0.0f, 1.0f));
  vec3 normal = directionOr(bpViewToWorld * normalView, view);
  GlassObject object;
  object.ior = bpGlassIor;
  object.form = BP_GLASS_FORM;
  object.sheet = BP_GLASS_SHEET != 0;
  object.thickness = bpGlassThickness BP_THICKNESS_FACTOR;
  object.center = bpGlassCenter;
  object.radius = bpGlassRadius;
  BpGlass glass;
#if BP_GLASS_FORM == 3 && !BP_GLASS_SHEET
  glass.seen = lookThroughGlass(bpGlassShell, object, position, normal, view, roughnessWithin(roughness), gl_FrontFacing == false,
                                length(position));
#else
  glass.seen = lookThroughGlass(0, object, position, normal, view, roughnessWithin(roughness), gl_FrontFacing == false,
                                length(position));
#endif
  glass.deviation = glassDeviation(object, glass.seen.through, position, view);
  glass.transmittance = glassTransmittance(bpGlassColor, bpGlassReach, glass.seen.through.distance);
  glass.mirrorTransmittance = vec3(1.0f);
  if (gl_FrontFacing == false && BP_GLASS_SHEET == 0)
  {
    glass.mirrorTransmittance = glassTransmittance(bpGlassColor, bpGlassReach,
                                                   glass.seen.followed ? glass.seen.mirrored.distance : length(position));
  }
  glass.position = positionView;
  glass.normal = normalView;
  glass.view = viewView;
  glass.roughness = roughness;
  if (glass.seen.followed)
  {
    glass.position = viewFromWorld * glass.seen.mirrored.position;
    glass.normal = viewFromWorld * glass.seen.mirrored.direction;
    glass.view = glass.normal;
    glass.roughness = sqrt(glass.seen.mirrored.alpha);
  }
  glass.looked = vec3(0.0f);
  return glass;
}

// The refracted lobe is symmetric around its ray, like that of a surface facing along it.
vec3 bpLookUpThrough(BpGlass glass)
{
  mat3 viewFromWorld = transpose(bpViewToWorld);
  vec3 direction = viewFromWorld * glass.seen.through.direction;
  vec3 position = viewFromWorld * glass.seen.through.position;
  vec4 behind = bpLookBehind(position, direction, glass.seen.through.alpha);
  if (behind.w > 0.999f) { return behind.rgb; }
  return behind.rgb + (1.0f - behind.w) * bpGatherLight(position, direction, direction, sqrt(glass.seen.through.alpha), 1.0f, 1.0f).specular;
}

// Factor of the reflection. The energy that a rough surface's facets lose (A + B of the split sum is below 1) is
// transmitted; but under total reflection all of it is reflected.
float bpGlassReflected(BpGlass glass, vec2 brdf)
{
  return glass.seen.reflectance >= 1.0f ? 1.0f : glass.seen.reflectance * (brdf.x + brdf.y);
}

// Transmittance for light from behind, by colour: what the surface does not reflect.
vec3 bpGlassPassed(BpGlass glass, vec3 reflected, vec3 albedo, float metallic)
{
  return bpGlassTransmission BP_TRANSMISSION_FACTOR * (1.0f - metallic) * (1.0f - reflected) * albedo * glass.transmittance;
}

// The part of it for which the frame behind is sharper than any cubemap.
float bpGlassStands(BpGlass glass, vec3 passed)
{
  float bent = clamp(glass.deviation / bpGlassStraight, 0.0f, 1.0f);
  float behind = gl_FrontFacing ? bpGlassBehind : 0.0f;
  return (1.0f - bent * (1.0f - behind)) * min(passed.r, min(passed.g, passed.b));
}
