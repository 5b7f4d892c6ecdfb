// From a rendered face (float, several samples a texel) to a texel of the probe: mean colour brought into half-float range,
// distance from the depth buffer. In a second use it draws only the texels that had to be changed, for an occlusion query
// to count them. Needs shared/cube.glsl.
uniform sampler2D bpColor;
uniform sampler2D bpDepth;
uniform int bpScale;      // samples along each side of a texel
uniform int bpFace;
uniform float bpFaceSize; // texels
uniform float bpNear;     // clipping distances of the capture, scene units
uniform float bpFar;
uniform int bpCount;      // 0: write; 1: keep texels out of range or not finite; 2: not finite only

const float kHalfMax = 65504.0f;
const float kFloatMax = 3.4e38f;

bool bpFinite(vec4 c) { return all(lessThanEqual(abs(c), vec4(kFloatMax))); }

void main()
{
  ivec2 corner = ivec2(gl_FragCoord.xy) * bpScale;
  vec4 sum = vec4(0.0f);
  bool finite = true;
  for (int y = 0; y < bpScale; ++y)
  {
    for (int x = 0; x < bpScale; ++x)
    {
      vec4 c = texelFetch(bpColor, corner + ivec2(x, y), 0);
      bool ok = bpFinite(c);
      finite = finite && ok;
      // Clamped sample by sample: an infinite sum would hide finite neighbours.
      sum += ok ? min(c, vec4(kHalfMax * float(bpScale * bpScale))) : vec4(0.0f);
    }
  }
  vec4 mean = sum / float(bpScale * bpScale);
  bool inRange = all(lessThanEqual(mean.rgb, vec3(kHalfMax)));
  if (bpCount == 1 && finite && inRange) { discard; }
  if (bpCount == 2 && finite) { discard; }

  // The sample nearest the texel's centre decides the distance; a mean over an edge would be a surface that is not there.
  float depth = texelFetch(bpDepth, corner + ivec2(bpScale / 2), 0).r;
  float viewDepth = 2.0f * bpNear * bpFar / (bpFar + bpNear - (2.0f * depth - 1.0f) * (bpFar - bpNear));
  vec2 st = 2.0f * gl_FragCoord.xy / bpFaceSize - 1.0f;
  float toDistance = length(cubeDirection(bpFace, st.x, st.y));

  gl_FragData[0] = vec4(clamp(mean.rgb, vec3(0.0f), vec3(kHalfMax)), clamp(mean.a, 0.0f, 1.0f));
  gl_FragData[1] = vec4(depth < 1.0f ? viewDepth * toDistance : 0.0f, 0.0f, 0.0f, 1.0f); // 0: nothing was hit
}
