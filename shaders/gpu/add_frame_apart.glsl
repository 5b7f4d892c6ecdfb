// As add_frame.glsl, for frames that keep the sampled reflection apart (reflection_apart.glsl).
uniform sampler2D bpColor;
uniform sampler2D bpReflection;

void main()
{
  gl_FragData[0] = texelFetch(bpColor, ivec2(gl_FragCoord.xy), 0);
  gl_FragData[1] = texelFetch(bpReflection, ivec2(gl_FragCoord.xy), 0);
}
