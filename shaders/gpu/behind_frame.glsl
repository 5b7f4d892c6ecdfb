// The frame that is seen through glass: colour drawn so far, premultiplied by its coverage, and depth. Drawn by
// filters/vtk/frame/behind_frame.cpp, which joins shared/finite.glsl before it.
uniform sampler2D bpColor;
uniform sampler2D bpDepth;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(bpDepth, at, 0).r;
  vec4 color = texelFetch(bpColor, at, 0);
  // Half floats end at 65504; means of levels must stay below. A single NaN would spread through the levels.
  vec3 light = clamp(finiteOr(color.rgb, vec3(0.0f)), vec3(0.0f), vec3(60000.0f));
  gl_FragData[0] = depth < 1.0f ? vec4(light, 1.0f) : vec4(0.0f);
  gl_FragData[1] = vec4(depth, 0.0f, 0.0f, 1.0f);
}
