// Lights that VTK has no code of its own for (filters/vtk/draw/listed_lights.h): 1024 texels wide, four a light, then
// indices of lights, four a texel.
uniform sampler2D bpLightList;
uniform ivec2 bpReaching;          // of this object: the texel of its first index, number of lights
uniform mat4 bpViewFromLightList;  // positions in the list are relative to the middle of the scene

vec4 bpListTexel(int at)
{
  return texelFetch(bpLightList, ivec2(at & 1023, at >> 10), 0);
}

struct BpListedLight
{
  vec3 color;
  vec3 positionView;
  vec3 directionView;
  float perRange;
  float outerDegrees;
  float innerCosine;
  bool positional;
};

BpListedLight bpListedLight(int place)
{
  int at = 4 * int(bpListTexel(bpReaching.x + (place >> 2))[place & 3]);
  vec4 where = bpListTexel(at), shine = bpListTexel(at + 1), axis = bpListTexel(at + 2);
  BpListedLight light;
  light.color = shine.rgb;
  light.positionView = (bpViewFromLightList * vec4(where.xyz, 1.0f)).xyz;
  light.directionView = mat3(bpViewFromLightList) * axis.xyz;
  light.perRange = where.w;
  light.outerDegrees = axis.w;
  light.innerCosine = bpListTexel(at + 3).x;
  light.positional = shine.a > 0.0f;
  return light;
}
