// The debug view's output: the value of the chosen row of filters/core/scene/surface_view.cpp, as a colour on the
// screen, as a number in linear pictures. Spliced in for the debug view only.
uniform vec2 bpViewRange;      // of scalars
// The lowest row: the colour map, 256 texels. Above it traced diffuse light, if there is any, from the picture's lowest
// row on; alpha: squared standard error, negative: not traced. Alpha of the first texel: that picture's width.
uniform sampler2D bpViewColors;
uniform vec3 bpFaceColors[6];
uniform int bpFinishShown;  // 1: the surface's finish instead of the common properties
uniform vec2 bpPerPixel;       // 1 over the picture's size
uniform float bpObject;        // index of the object + 1, for picking

const vec3 kUndefined = vec3(-1.0f);

#if BP_LIT
// What noise alone explains is no error.
vec3 bpDiffuseError()
{
  int rows = textureSize(bpViewColors, 0).y - 1;
  if (rows == 0 || bpDiffuseLight.x < 0.0f) { return kUndefined; }
  vec2 size = vec2(texelFetch(bpViewColors, ivec2(0, 0), 0).a, float(rows));
  ivec2 at = ivec2(clamp(gl_FragCoord.xy * bpPerPixel * size, vec2(0.0f), size - 1.0f));
  vec4 truth = texelFetch(bpViewColors, at + ivec2(0, 1), 0);
  if (truth.a < 0.0f) { return kUndefined; }
  vec3 off = bpDiffuseLight - truth.rgb;
  float squares = max(dot(off, off) - truth.a, 0.0f);
  return vec3(min(sqrt(squares / max(dot(truth.rgb, truth.rgb), 1.0e-20f)), 1.0e4f));
}

vec3 bpViewValue()
{
  bool traced = bpBest.share > 0.0f;
  bool known = traced && bpBest.trueDistance < kNoHit;
  float level = bpBest.fetches > 0.0f ? bpBest.levelSum / bpBest.fetches : -1.0f;
  if (bpView == 1) { return traced && bpBest.hit.distance < 1.0e38f ? vec3(bpBest.hit.distance) : kUndefined; }
  if (bpView == 2) { return known ? vec3(bpBest.trueDistance) : kUndefined; }
  if (bpView == 3)
  {
    return known && bpBest.hit.distance < 1.0e38f ? vec3(abs(bpBest.hit.distance - bpBest.trueDistance)) : kUndefined;
  }
  if (bpView == 4)
  {
    if (!known) { return kUndefined; }
    vec3 a = normalize(bpBest.lookup);
    vec3 b = normalize(bpBest.truth);
    return vec3(atan(length(cross(a, b)), dot(a, b)) * 57.2957795f);
  }
  if (bpView == 5) { return vec3(level); }
  if (bpView == 6) { return level >= 0.0f ? vec3(roughnessForLevel(level, bpBest.maxLevel)) : kUndefined; }
  if (bpView == 7) { return traced ? 0.5f * normalize(bpBest.lookup) + 0.5f : kUndefined; }
  if (bpView == 8) { return bpWeightColor; }
  if (bpView == 9) { return traced ? vec3(float(bpBest.hit.face)) : kUndefined; }
  if (bpView == 11) { return bpDiffuseLight; }
  if (bpView == 12) { return bpNodeShare > 0.0f ? vec3(bpNodeKnown / bpNodeShare) : kUndefined; }
  if (bpView == 13) { return bpDiffuseError(); }
  return vec3(bpLookups);
}
#else
// No lookups: an unlit material, or probes are switched off.
vec3 bpViewValue()
{
  return bpView == 10 ? vec3(0.0f) : kUndefined;
}
#endif

vec3 bpViewColor(vec3 color)
{
  if (bpView == 0) { return bpOutput(color); }
  vec3 value = bpViewValue();
  if (bpExposure < 0.0f) { return value; }
  if (value.x < 0.0f)
  {
    // Hatched: unlike any colour of a scale, on any surface.
    float stripe = fract((gl_FragCoord.x + gl_FragCoord.y) / 12.0f);
    return vec3(stripe < 0.5f ? 0.30f : 0.36f);
  }
  if (bpView == 9) { return bpFaceColors[int(value.x + 0.5f)]; }
  if (bpView == 7 || bpView == 8) { return value; }
  if (bpView == 11) { return bpOutput(value); }
  float x = clamp((value.x - bpViewRange.x) / max(bpViewRange.y - bpViewRange.x, 1.0e-30f), 0.0f, 1.0f);
  int below = min(int(x * 255.0f), 254);
  return mix(texelFetch(bpViewColors, ivec2(below, 0), 0).rgb, texelFetch(bpViewColors, ivec2(below + 1, 0), 0).rgb,
             x * 255.0f - float(below));
}
