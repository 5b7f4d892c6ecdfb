// The shadow of moving objects: a depth map from light @LIGHT@, nine interpolated comparisons.
uniform sampler2DShadow bpMovingMap@LIGHT@;
uniform mat4 bpMovingFromEye@LIGHT@;  // of points relative to the eye, world axes, to the map's coordinates
uniform float bpMovingOn@LIGHT@;  // 0 in captures, which exclude moving objects

float bpMovingShadow@LIGHT@(vec3 positionView)
{
  vec4 p = bpMovingFromEye@LIGHT@ * vec4(bpViewToWorld * positionView, 1.0f);
  if (p.w <= 0.0f || bpMovingOn@LIGHT@ <= 0.0f) { return 1.0f; }
  vec3 at = p.xyz / p.w;
  // There are no moving objects outside its edges; beyond its far end they are in front.
  if (any(lessThan(at.xy, vec2(0.0f))) || any(greaterThan(at.xy, vec2(1.0f))) || at.z < 0.0f) { return 1.0f; }
  at.z = min(at.z, 1.0f);
  float sum = 0.0f;
  for (int i = 0; i < 9; ++i)
  {
    sum += textureLod(bpMovingMap@LIGHT@, at + vec3(vec2(i % 3 - 1, i / 3 - 1) / BP_MOVING_MAP_SIZE, 0.0f), 0.0f);
  }
  return sum / 9.0f;
}
