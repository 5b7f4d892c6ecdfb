// The shadow of what stands still before a sun: a depth map of it as the light @LIGHT@ sees it, nine comparisons, each of them
// interpolated. Looked up off the surface, so that a slanted one does not shade itself.
uniform sampler2DShadow bpSunMap@LIGHT@;
uniform mat4 bpSunFromEye@LIGHT@;  // of points relative to the eye, world axes, to the map's coordinates
uniform vec3 bpSunTaps@LIGHT@;     // how far they are apart, in the map's coordinates; how far off the surface, scene units

float bpSunShadow@LIGHT@(vec3 positionView, vec3 normalView)
{
  vec3 off = bpViewToWorld * (positionView + bpSunTaps@LIGHT@.z * normalView);
  vec3 at = (bpSunFromEye@LIGHT@ * vec4(off, 1.0f)).xyz;
  // Beyond its edges nothing stands; behind its far end, what does is in front.
  if (any(lessThan(at, vec3(0.0f))) || any(greaterThan(at.xy, vec2(1.0f)))) { return 1.0f; }
  at.z = min(at.z, 1.0f);
  float sum = 0.0f;
  for (int i = 0; i < 9; ++i)
  {
    sum += textureLod(bpSunMap@LIGHT@, at + vec3(vec2(i % 3 - 1, i / 3 - 1) * bpSunTaps@LIGHT@.xy, 0.0f), 0.0f);
  }
  return sum / 9.0f;
}
