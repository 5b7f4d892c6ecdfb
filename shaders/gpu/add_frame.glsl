// Adds one frame to the sum of frames, with the host's additive blending. `bpScale`: for how many frames it counts.
uniform sampler2D bpColor;
uniform float bpScale;

void main()
{
  gl_FragData[0] = bpScale * texelFetch(bpColor, ivec2(gl_FragCoord.xy), 0);
}
