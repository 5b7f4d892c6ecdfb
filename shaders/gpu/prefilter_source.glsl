// One face of one level of the source's mip chain, from the previous level, the only one the texture exposes during
// this pass. Needs shared/cube.glsl, shared/source_level.glsl, gpu/nearest_half.glsl.
uniform samplerCube bpSource;
uniform int bpFace;
uniform float bpFaceSize; // texels of the level written
uniform float bpLevel;    // read

void main()
{
  vec2 st = 2.0f * gl_FragCoord.xy / bpFaceSize - 1.0f;
  vec4 sum = vec4(0.0f);
  float weight = 0.0f;
  for (int i = 0; i < 4; ++i)
  {
    float s = sourceLookup(st.x, (i & 1) == 0 ? -1.0f : 1.0f, bpFaceSize);
    float t = sourceLookup(st.y, (i & 2) == 0 ? -1.0f : 1.0f, bpFaceSize);
    float w = sourceWeight(s, t);
    sum += w * textureLod(bpSource, cubeDirection(bpFace, s, t), bpLevel);
    weight += w;
  }
  gl_FragData[0] = nearestHalf(sum / weight);
}
