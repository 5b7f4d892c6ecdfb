// Draws the averaged frames to the screen with their depth, so that what is drawn on top can be hidden. Needs
// output_uniforms.glsl and output.glsl.
uniform sampler2D bpColor;
uniform sampler2D bpDepth;
uniform float bpScale;    // 1 / frames, times their share of the picture
uniform sampler2D bpBefore;    // the picture that these frames replace
uniform float bpBeforeScale;  // the same for that picture; 0: there is none
uniform int bpFiner;      // texels along each side of a pixel
uniform int bpOver;       // 1: blended over what is there, by coverage
uniform ivec2 bpCorner;   // of the picture, in the framebuffer

void main()
{
  ivec2 at = (ivec2(gl_FragCoord.xy) - bpCorner) * bpFiner;
  vec4 sum = vec4(0.0f);
  for (int y = 0; y < bpFiner; ++y)
  {
    for (int x = 0; x < bpFiner; ++x) { sum += texelFetch(bpColor, at + ivec2(x, y), 0); }
  }
  vec4 mean = sum * (bpScale / float(bpFiner * bpFiner));
  if (bpBeforeScale > 0.0f) { mean += bpBeforeScale * texelFetch(bpBefore, at, 0); }
  gl_FragData[0] = bpOver == 1 ? mean.a * vec4(bpOutput(mean.rgb / max(mean.a, 1.0e-4f)), 1.0f)
                               : vec4(bpOutput(mean.rgb), mean.a);
  gl_FragDepth = texelFetch(bpDepth, at, 0).r;
}
