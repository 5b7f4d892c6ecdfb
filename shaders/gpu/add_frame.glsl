// One frame into the sum of frames: the host blends by addition.
uniform sampler2D bpColor;

void main()
{
  gl_FragData[0] = texelFetch(bpColor, ivec2(gl_FragCoord.xy), 0);
}
