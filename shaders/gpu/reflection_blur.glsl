// One of two passes that smooth the sampled reflection: a mean over 5 x 5 pixels, `bpStep` apart, on the same surface
// (a joint bilateral filter; the steps of 1 and 2 form the start of an a-trous transform). The width depends on the
// lobe, because mirrors show detail, and on the number of rays, because noise decreases with it. Incoming light is
// smoothed; the surface's reflectance, with all textures, is multiplied afterwards.
uniform sampler2D bpReflection; // rgb incoming light, a roughness
uniform sampler2D bpSurface;    // normal and depth, view space
uniform float bpScale;          // of bpReflection: 1 / frames
uniform int bpStep;             // pixels
uniform float bpRays;  // per pixel, in all frames
uniform vec2 bpTangents;        // half the picture at depth 1, or half its size under parallel projection
uniform vec2 bpSize;            // pixels
uniform float bpParallelView;   // 1 under parallel projection
#if BP_LAST
uniform sampler2D bpColor;      // sum of frames
uniform sampler2D bpFirst;      // reflection before the first pass, sum of frames
uniform sampler2D bpShare;  // factor of the incoming light, from the surface
uniform float bpColorScale;     // 1 / frames
#endif

const float kWidest = 9.0f;  // variance in pixels²: beyond it, detail would be smoothed as well as noise
const float kOfLobe = 0.35f;  // standard deviation over alpha, in heights of the picture: the size of a lobe's detail on screen
const float kQuietRays = 24.0f;  // the number of rays at which half of the variance is enough

vec3 place(ivec2 pixel, float depth)
{
  vec2 across = (2.0f * (vec2(pixel) + 0.5f) / bpSize - 1.0f) * bpTangents;
  return vec3(across * (bpParallelView > 0.5f ? 1.0f : depth), -depth);
}

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 middle = texelFetch(bpReflection, at, 0) * bpScale;
  vec4 surface = texelFetch(bpSurface, at, 0);
  vec3 normal = normalize(surface.xyz + vec3(0.0f, 0.0f, 1.0e-20f));
  float alpha = middle.a * middle.a;
  float reach = kOfLobe * alpha * bpSize.y;
  // The two passes together have five times the variance of the first.
  float variance = min(reach * reach, kWidest) / (1.0f + bpRays / kQuietRays) / 5.0f * float(bpStep * bpStep);
  vec4 sum = middle;
  float weights = 1.0f;
  if (surface.w > 0.0f && variance > 1.0e-3f)
  {
    vec3 here = place(at, surface.w);
    float pixel = 2.0f * bpTangents.y * (bpParallelView > 0.5f ? 1.0f : surface.w) / bpSize.y;
    float turn = 0.25f * alpha + 0.02f;  // radians between normals whose lobes see about the same
    ivec2 last = ivec2(bpSize) - 1;
    for (int y = -2; y <= 2; ++y)
    {
      for (int x = -2; x <= 2; ++x)
      {
        ivec2 shift = ivec2(x, y) * bpStep;
        ivec2 to = at + shift;
        if ((x == 0 && y == 0) || any(lessThan(to, ivec2(0))) || any(greaterThan(to, last))) { continue; }
        vec4 other = texelFetch(bpSurface, to, 0);
        if (other.w <= 0.0f) { continue; }
        vec4 light = texelFetch(bpReflection, to, 0) * bpScale;
        float off = dot(normal, place(to, other.w) - here) / (3.0f * pixel);  // distance from the plane, relative to its tolerance
        float bend = acos(clamp(dot(normal, normalize(other.xyz)), -1.0f, 1.0f)) / turn;
        float rough = (light.a - middle.a) / 0.05f;
        float w = exp(-0.5f * float(shift.x * shift.x + shift.y * shift.y) / variance - off * off - bend * bend - rough * rough);
        sum += w * light;
        weights += w;
      }
    }
  }
  vec4 smoothed = vec4(sum.rgb / weights, middle.a);
#if BP_LAST
  vec4 color = texelFetch(bpColor, at, 0) * bpColorScale;
  vec3 change = smoothed.rgb - texelFetch(bpFirst, at, 0).rgb * bpColorScale;
  gl_FragData[0] = vec4(max(color.rgb + change * texelFetch(bpShare, at, 0).rgb, vec3(0.0f)), color.a);
#else
  gl_FragData[0] = smoothed;
#endif
}
