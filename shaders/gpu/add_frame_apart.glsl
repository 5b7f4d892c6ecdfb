// As add_frame.glsl, for frames with a separate sampled reflection (reflection_apart.glsl).
uniform sampler2D bpColor;
uniform sampler2D bpReflection;

void main()
{
  gl_FragData[0] = texelFetch(bpColor, ivec2(gl_FragCoord.xy), 0);
  gl_FragData[1] = texelFetch(bpReflection, ivec2(gl_FragCoord.xy), 0);
}
