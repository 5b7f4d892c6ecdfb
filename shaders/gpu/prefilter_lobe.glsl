// One face of one prefiltered level: filters the captured radiance with a lobe around each texel's direction. The
// samples are the same for all texels, so the host computes them once per level (filters/math/sampling/filter_lobe.h);
// filters/math/cube/cube_filter.cpp is the CPU version of this file. Needs shared/cube.glsl, shared/lobe_frame.glsl,
// shared/edge_fixup.glsl, gpu/nearest_half.glsl; with BP_FLAT_SOURCE gpu/flat_lookup.glsl.
#ifdef BP_FLAT_SOURCE
uniform sampler2D bpSource;
uniform float bpSourceSize; // texels of its level 0
uniform float bpSourceMaxLevel;
#else
uniform samplerCube bpSource;
#endif
uniform int bpFace;
uniform float bpFaceSize; // texels of the level written
#ifdef BP_EDGE_FIXUP // a program of its own: software renderers do not skip branches
uniform float bpFixupWidth; // texels
#endif
uniform int bpTapCount;
// A block of its own: uniforms of a program may be limited to 1,024 numbers. Each tap: x and y, the direction in the
// lobe's frame; z, the level of the source; w, its weight. Weights sum to 1.
layout(std140) uniform bpTapBlock { vec4 bpTaps[768]; };

vec4 lobeMean(vec3 n)
{
  vec3 t = lobeTangent(n);
  vec3 b = lobeBitangent(n);
  vec4 sum = vec4(0.0f);
  for (int i = 0; i < bpTapCount; ++i)
  {
    vec4 tap = bpTaps[i];
    float z = sqrt(max(1.0f - tap.x * tap.x - tap.y * tap.y, 0.0f));
    vec3 d = tap.x * t + tap.y * b + z * n;
#ifdef BP_FLAT_SOURCE
    sum += tap.w * bpFlatLookup(bpSource, d, tap.z, bpSourceSize, bpSourceMaxLevel);
#else
    sum += tap.w * textureLod(bpSource, d, tap.z);
#endif
  }
  return sum;
}

void main()
{
  vec2 st = 2.0f * gl_FragCoord.xy / bpFaceSize - 1.0f;
  vec4 value = lobeMean(normalize(cubeDirection(bpFace, st.x, st.y)));

#ifdef BP_EDGE_FIXUP
  float last = 1.0f - 1.0f / bpFaceSize; // of the texels at the edge
  float shareS = edgeFixupShare((last - abs(st.x)) * 0.5f * bpFaceSize, bpFixupWidth);
  float shareT = edgeFixupShare((last - abs(st.y)) * 0.5f * bpFaceSize, bpFixupWidth);
  if (shareS > 0.0f)
  {
    float side = sign(st.x);
    value += edgeFixupPull(shareS, shareT) *
      (lobeMean(normalize(directionAcrossEdge(bpFace, side, st.y, false, bpFaceSize))) -
        lobeMean(normalize(cubeDirection(bpFace, side * last, st.y))));
  }
  if (shareT > 0.0f)
  {
    float side = sign(st.y);
    value += edgeFixupPull(shareT, shareS) *
      (lobeMean(normalize(directionAcrossEdge(bpFace, side, st.x, true, bpFaceSize))) -
        lobeMean(normalize(cubeDirection(bpFace, st.x, side * last))));
  }
#endif
  gl_FragData[0] = nearestHalf(max(value, vec4(0.0f)));
}
