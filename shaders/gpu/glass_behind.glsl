// Samples opaque objects behind glass from the frame along a refracted ray: shaders/gpu/glass.glsl does this before it
// samples probes. Positions are in view space. The hit is found in the frame's depth; hits that the depth does not
// confirm, or outside the frame, are left to the probes.
uniform float bpBehindOn;       // 0: there is no frame (captures, debug views)
uniform sampler2D bpBehindColor;  // premultiplied by coverage, with mip levels
uniform sampler2D bpBehindDepth;
uniform mat4 bpBehindClip;      // clip from view
uniform vec2 bpBehindSize;      // pixels

// View depth (z) for a depth of the frame, perspective or parallel.
float bpBehindZ(float depth)
{
  float ndc = 2.0f * depth - 1.0f;
  float slope = ndc * bpBehindClip[2][3] - bpBehindClip[2][2];
  return (bpBehindClip[3][2] - ndc * bpBehindClip[3][3]) / (abs(slope) > 1.0e-20f ? slope : 1.0e-20f);
}

// Colour times coverage, and coverage. `alpha`: GGX alpha of a mirror with the same scattering.
vec4 bpLookBehind(vec3 exitView, vec3 directionView, float alpha)
{
  if (bpBehindOn < 0.5f || !(directionView.z < -0.05f)) { return vec4(0.0f); }
  float far = 0.0f;
  float before = 0.0f;
  vec2 place = vec2(0.5f);
  float w = 1.0f;
  float z = 0.0f;
  // Each step goes to the frame's depth at the end of the previous one.
  for (int i = 0; i < 6; ++i)
  {
    vec4 clip = bpBehindClip * vec4(exitView + far * directionView, 1.0f);
    w = max(clip.w, 1.0e-6f);
    place = 0.5f * clip.xy / w + vec2(0.5f);
    before = far;
    z = bpBehindZ(textureLod(bpBehindDepth, clamp(place, vec2(0.0f), vec2(1.0f)), 0.0f).r);
    far = max((z - exitView.z) / directionView.z, 0.0f);
  }
  // Objects in front of the glass are not behind it.
  float own = bpBehindZ(gl_FragCoord.z);
  if (z > own + 1.0e-3f * abs(own)) { return vec4(0.0f); }
  // Relative movement of the last step: 5 % is the difference between neighbouring pixels of a slanted floor.
  float settled = 1.0f - smoothstep(0.02f, 0.05f, abs(far - before) / max(abs(exitView.z) + far, 1.0e-6f));
  vec2 inside = smoothstep(vec2(0.0f), vec2(0.05f), min(place, vec2(1.0f) - place));
  // Half of a GGX lobe's light lies within 2 alpha of its axis; half of a linear filter's weight within .59 of a
  // level's texel.
  float pixels = (2.0f / 0.59f) * alpha * far * abs(bpBehindClip[1][1]) * 0.5f * bpBehindSize.y / w;
  vec4 seen = textureLod(bpBehindColor, place, log2(max(pixels, 1.0f)));
  return settled * inside.x * inside.y * seen;
}
