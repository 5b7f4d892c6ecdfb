// Adds one frame to the sum of frames, with the host's additive blending.
uniform sampler2D bpColor;

void main()
{
  gl_FragData[0] = texelFetch(bpColor, ivec2(gl_FragCoord.xy), 0);
}
