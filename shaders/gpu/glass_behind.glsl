// What the frame shows of opaque things along a refracted ray: shaders/gpu/glass.glsl looks it up before it asks the probes. Positions
// are in view space here. Where the ray meets what was drawn is found from the frame's depth; a hit that the frame cannot confirm, or
// that lies outside of it, is left to the probes.
uniform float bpBehindOn;       // 0: there is no frame (captures, debug views)
uniform sampler2D bpBehindColor;  // premultiplied by coverage, with mip levels
uniform sampler2D bpBehindDepth;
uniform mat4 bpBehindClip;      // clip from view
uniform vec2 bpBehindSize;      // pixels

// View depth (z) of a depth of the frame's, perspective or parallel.
float bpBehindZ(float depth)
{
  float ndc = 2.0f * depth - 1.0f;
  float slope = ndc * bpBehindClip[2][3] - bpBehindClip[2][2];
  return (bpBehindClip[3][2] - ndc * bpBehindClip[3][3]) / (abs(slope) > 1.0e-20f ? slope : 1.0e-20f);
}

// Colour times coverage, and coverage. `alpha`: GGX alpha of a mirror that would scatter as far.
vec4 bpLookBehind(vec3 exitView, vec3 directionView, float alpha)
{
  if (bpBehindOn < 0.5f || !(directionView.z < -0.05f)) { return vec4(0.0f); }
  float far = 0.0f;
  float before = 0.0f;
  vec2 place = vec2(0.5f);
  float w = 1.0f;
  float z = 0.0f;
  // Each step goes to the depth that the frame has where the last one ended.
  for (int i = 0; i < 6; ++i)
  {
    vec4 clip = bpBehindClip * vec4(exitView + far * directionView, 1.0f);
    w = max(clip.w, 1.0e-6f);
    place = 0.5f * clip.xy / w + vec2(0.5f);
    before = far;
    z = bpBehindZ(textureLod(bpBehindDepth, clamp(place, vec2(0.0f), vec2(1.0f)), 0.0f).r);
    far = max((z - exitView.z) / directionView.z, 0.0f);
  }
  // What stands before the glass is not behind it.
  float own = bpBehindZ(gl_FragCoord.z);
  if (z > own + 1.0e-3f * abs(own)) { return vec4(0.0f); }
  // The last step moved by this share of the way from the eye: 5 % is what neighbouring pixels of a slanted floor differ by.
  float settled = 1.0f - smoothstep(0.02f, 0.05f, abs(far - before) / max(abs(exitView.z) + far, 1.0e-6f));
  vec2 inside = smoothstep(vec2(0.0f), vec2(0.05f), min(place, vec2(1.0f) - place));
  // Half of a GGX lobe's light lies within 2 alpha of its middle, half of what a level's linear filter weighs within .59 of a texel.
  float pixels = (2.0f / 0.59f) * alpha * far * abs(bpBehindClip[1][1]) * 0.5f * bpBehindSize.y / w;
  vec4 seen = textureLod(bpBehindColor, place, log2(max(pixels, 1.0f)));
  return settled * inside.x * inside.y * seen;
}
