// Converts a rendered face (float, several samples per texel) to texels of the probe: mean colour clamped to half-float
// range, distance from the depth buffer. An occlusion query counts the texels drawn: almost always all are valid, and
// one pass is enough. Needs shared/cube.glsl.
uniform sampler2D bpColor;
uniform sampler2D bpDepth;
uniform int bpScale;      // samples along each side of a texel
uniform int bpFace;
uniform float bpFaceSize; // texels
uniform float bpNear;     // clipping distances of the capture, scene units
uniform float bpFar;
uniform int bpKeep;  // 0: valid texels; 1: all, clamped; 2: only those that are not finite

const float kHalfMax = 65504.0f;
const float kFloatMax = 3.4e38f;

bool bpFinite(vec4 c) { return all(lessThanEqual(abs(c), vec4(kFloatMax))); }

// Tolerance of window depth from a linear function on a plane: rounding, and a share of the remaining depth range.
float bpFlat(float depth) { return 1.0e-6f + 0.02f * (1.0f - depth); }

// Does the depth step between the two samples at the centre, along `side`, continue to at least one of its ends? On a
// plane it does; at an edge parallel to the rows of samples it does not, although opposite corners of the four have
// equal sums there.
bool bpGoesOn(ivec2 middle, ivec2 side, float farthest)
{
  ivec2 last = ivec2(int(bpFaceSize) * bpScale - 1);
  float here = texelFetch(bpDepth, middle, 0).r;
  float before = texelFetch(bpDepth, middle - side, 0).r;
  float after = texelFetch(bpDepth, min(middle + side, last), 0).r;
  float earlier = texelFetch(bpDepth, max(middle - 2 * side, ivec2(0)), 0).r;
  float step = here - before;
  return min(abs(after - here - step), abs(before - earlier - step)) <= bpFlat(farthest);
}

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
      // Clamps each sample: an infinite sum would hide finite neighbours.
      sum += ok ? min(c, vec4(kHalfMax * float(bpScale * bpScale))) : vec4(0.0f);
    }
  }
  vec4 mean = sum / float(bpScale * bpScale);
  bool inRange = all(lessThanEqual(mean.rgb, vec3(kHalfMax)));
  if (bpKeep == 0 && !(finite && inRange)) { discard; }
  if (bpKeep == 2 && finite) { discard; }

  // Distance at the texel's centre, which is between samples if their number is even. Window depth is linear across a
  // plane, so the mean of the samples around the centre is exact on one. Across an edge the mean would be a surface
  // that does not exist, so the nearest sample is used.
  ivec2 middle = corner + ivec2(bpScale / 2);
  float depth = texelFetch(bpDepth, middle, 0).r;
  if (bpScale % 2 == 0)
  {
    float a = texelFetch(bpDepth, middle - ivec2(1, 1), 0).r;
    float b = texelFetch(bpDepth, middle - ivec2(1, 0), 0).r;
    float c = texelFetch(bpDepth, middle - ivec2(0, 1), 0).r;
    float farthest = max(max(a, b), max(c, depth));
    bool plane = farthest < 1.0f && bpGoesOn(middle, ivec2(1, 0), farthest) && bpGoesOn(middle, ivec2(0, 1), farthest) &&
                 abs(a + depth - b - c) <= bpFlat(farthest);
    if (plane) { depth = 0.25f * (a + b + c + depth); }
    else { depth = min(min(a, b), min(c, depth)); }
  }
  float viewDepth = 2.0f * bpNear * bpFar / (bpFar + bpNear - (2.0f * depth - 1.0f) * (bpFar - bpNear));
  vec2 st = 2.0f * gl_FragCoord.xy / bpFaceSize - 1.0f;
  float toDistance = length(cubeDirection(bpFace, st.x, st.y));

  gl_FragData[0] = vec4(clamp(mean.rgb, vec3(0.0f), vec3(kHalfMax)), clamp(mean.a, 0.0f, 1.0f));
  gl_FragData[1] = vec4(depth < 1.0f ? viewDepth * toDistance : 0.0f, 0.0f, 0.0f, 1.0f);  // 0: nothing was hit
}
