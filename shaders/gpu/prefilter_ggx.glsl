// One face of one prefiltered level: the GGX lobe around N = V = R over the captured radiance (split sum, Karis 2013). The
// sample directions are the same for every texel, so the host computes them once a level: xyz in the texel's tangent
// frame (z = R), w = level of the source's mip chain whose texel covers the sample's share of solid angle (filtered
// importance sampling, Krivanek and Colbert 2008). Needs shared/cube.glsl.
uniform samplerCube bpSource;
uniform int bpFace;
uniform float bpFaceSize; // texels of the level written
uniform int bpSampleCount;
uniform vec4 bpSamples[128];

void main()
{
  vec2 st = 2.0f * gl_FragCoord.xy / bpFaceSize - 1.0f;
  vec3 n = normalize(cubeDirection(bpFace, st.x, st.y));
  // Duff et al. 2017: a frame without a singular pole switch in the middle of a face.
  float s = n.z < 0.0f ? -1.0f : 1.0f;
  float a = -1.0f / (s + n.z);
  float b = n.x * n.y * a;
  vec3 t = vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x);
  vec3 u = vec3(b, s + n.y * n.y * a, -n.y);

  vec4 sum = vec4(0.0f);
  float weight = 0.0f;
  for (int i = 0; i < bpSampleCount; ++i)
  {
    vec4 l = bpSamples[i];
    sum += l.z * textureLod(bpSource, l.x * t + l.y * u + l.z * n, l.w);
    weight += l.z;
  }
  gl_FragData[0] = sum / weight;
}
