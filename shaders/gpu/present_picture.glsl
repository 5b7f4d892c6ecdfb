// The mean of the frames onto the screen, with the depth of what it shows, so that whatever is drawn over it can be hidden
// by it. Needs output_uniforms.glsl and output.glsl.
uniform sampler2D bpColor;
uniform sampler2D bpDepth;
uniform float bpScale;    // 1 / frames

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 mean = texelFetch(bpColor, at, 0) * bpScale;
  gl_FragData[0] = vec4(bpOutput(mean.rgb), mean.a);
  gl_FragDepth = texelFetch(bpDepth, at, 0).r;
}
