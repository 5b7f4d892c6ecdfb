// Which reflections show lamps by their shapes, and which in the map. A mirror's are sharp in the map and as right as all else in it. A rough
// surface's are blurred there around the capture origin, and the shape is right everywhere. Needs lamp_types.glsl.

// Colour, of mean 1, of lamps whose light is `light`; where that is none, of `first`.
vec3 lampColor(vec3 light, vec3 first)
{
  float mean = (light.x + light.y + light.z) / 3.0f;
  float meanOfFirst = (first.x + first.y + first.z) / 3.0f;
  return mean > 1.0e-12f ? light / mean : (meanOfFirst > 1.0e-12f ? first / meanOfFirst : vec3(1.0f));
}

// Share of the shapes in a reflection of that roughness; the map's lamps have the rest.
float lampsByShape(float roughness)
{
  float t = clamp(10.0f * (roughness - kLampMapRoughness), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}
