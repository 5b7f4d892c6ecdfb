// What glass is looked through at: colour of what is drawn so far, premultiplied by its coverage, and its depth. Drawn by
// filters/vtk/frame/behind_frame.cpp, which joins shared/finite.glsl before it.
uniform sampler2D bpColor;
uniform sampler2D bpDepth;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(bpDepth, at, 0).r;
  vec4 color = texelFetch(bpColor, at, 0);
  // Half floats end at 65504; the levels' means stay below. One broken pixel would make a whole level so.
  vec3 light = clamp(finiteOr(color.rgb, vec3(0.0f)), vec3(0.0f), vec3(60000.0f));
  gl_FragData[0] = depth < 1.0f ? vec4(light, 1.0f) : vec4(0.0f);
  gl_FragData[1] = vec4(depth, 0.0f, 0.0f, 1.0f);
}
