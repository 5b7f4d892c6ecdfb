// Marches a ray through a probe's relief (filters/math/cube/relief.h), block by block, as Hi-Z tracing does in a depth
// buffer and light field probes (McGuire et al. 2017) in their distances. Within a face of the cube, reciprocal depth
// is linear along the ray and across a plane, so blocks of texels are bounded by planes instead of distances: a flat
// wall is a single block, met exactly, however obliquely the probe saw it. Each step takes one sample:
//
// A block that the ray passes in front of is skipped, and the next one is twice as large. Where the ray may pass behind
// a block's surface, a quarter of the block is examined; a flat block contains the hit. A ray that is behind as it
// enters a block has passed a silhouette: it is hidden until it emerges, or is inside the occluder, which is assumed to
// extend behind the visible side, straight back like a pillar.
//
// The host supplies fetchProbeRelief, probeReliefSize and reliefFromProbe: the box may be rotated against the map.
#ifndef BP_MARCH
#define BP_MARCH 1
#endif
#if BP_MARCH > 0

struct ReliefMarch
{
  float met;  // distance along the ray to the hit on what the probe saw; negative: none
  float lost;  // where it was last visible before it went behind something; negative: visible
  float way;  // how far it was followed
};

// `start`, `farthest`: along the unit vector `reflection`, scene units; there must be nothing before `start`.
ReliefMarch marchRelief(ProbeShape probe, vec3 position, vec3 reflection, float start, float farthest, float steps)
{
  const int kMost = 256;
  const float kFlat = 0.01f;  // of the depth: maximum slack of a block that counts as a plane
  const float kOn = 1.0e-3f;  // of the distance: nearer is on the surface
  const float kPassed = 0.02f;  // of the distance: further behind at a block's border, a silhouette was passed
  const float kDeep = 0.3f;  // of the distance: assumed depth of objects
  const float kSame = 0.02f;  // of the distance: nearer to a plane is on it
  const float kInto = 0.01f;  // texels that a step goes into the next block, so that rounding does not keep it back
  const float kBeside = 1.5f;  // texels from a silhouette within which the surface behind is used unmixed
  const float kCells = 32.0f;  // along a face: the initial blocks

  ReliefMarch march;
  march.met = -1.0f;
  march.lost = -1.0f;
  float size = probeReliefSize(probe);
  vec3 p = reliefFromProbe(probe, position);
  vec3 r = reliefFromProbe(probe, reflection);
  float top = max(floor(log2(size) - 0.5f), 0.0f);
  float first = max(floor(log2(size / kCells) + 0.5f), 0.0f);
  float level = first;
  float t = start;
  bool fresh = start > 0.0f;
  bool behind = false;
  float used = 0.0f;
  for (int i = 0; i < kMost; ++i)
  {
    if (float(i) + used >= steps) { break; }
    vec3 x = p + t * r;
    vec4 bound = fetchProbeRelief(probe, x, level);

    // Rotated so that the block's face is z = 1.
    vec3 a = abs(x);
    vec3 q = x;
    vec3 d = r;
    if (a.x >= a.y && a.x >= a.z)
    {
      q = vec3(x.y, x.z, x.x);
      d = vec3(r.y, r.z, r.x);
    }
    else if (a.y >= a.z)
    {
      q = vec3(x.z, x.x, x.y);
      d = vec3(r.z, r.x, r.y);
    }
    float side = q.z < 0.0f ? -1.0f : 1.0f;
    float depth = max(side * q.z, 1.0e-30f);
    float deepens = side * d.z;

    // Distances to the two borders of the block towards which the ray moves; none if it turns too little.
    float cells = floor(size * exp2(-level) + 0.5f);
    float turnX = d.x * depth - q.x * deepens;
    float turnY = d.y * depth - q.y * deepens;
    float lineX = clamp(floor((0.5f * q.x / depth + 0.5f) * cells), 0.0f, cells - 1.0f) + (turnX > 0.0f ? 1.0f : 0.0f);
    float lineY = clamp(floor((0.5f * q.y / depth + 0.5f) * cells), 0.0f, cells - 1.0f) + (turnY > 0.0f ? 1.0f : 0.0f);
    float borderX = 2.0f * lineX / cells - 1.0f;
    float borderY = 2.0f * lineY / cells - 1.0f;
    float gapX = borderX * depth - q.x;
    float gapY = borderY * depth - q.y;
    float speedX = d.x - borderX * deepens;
    float speedY = d.y - borderY * deepens;
    float farther = farthest - t;
    float wayX = gapX * speedX > 0.0f ? gapX / speedX : (gapX * turnX > 0.0f ? farther : 0.0f);
    float wayY = gapY * speedY > 0.0f ? gapY / speedY : (gapY * turnY > 0.0f ? farther : 0.0f);
    float line = wayX < wayY ? lineX : lineY;
    float way = min(min(wayX, wayY), farther);
    float depthOut = depth + way * deepens;
    // The size of a texel along the ray, here and at the border.
    float texel = 2.0f / (size * max(max(abs(turnX), abs(turnY)), 1.0e-30f));
    float next = t + way + kInto * texel * depthOut * depthOut;

    // Distance in front of the nearest and farthest surface of the block, here and at the border; relative to the
    // distance.
    float slack = level > 0.5f ? bound.w : 0.0f;
    bool flatBlock = slack * depth < kFlat;
    float speed = -dot(vec3(bound.x, bound.y, bound.z), r);
    float ahead = 1.0f - dot(vec3(bound.x, bound.y, bound.z), x);
    float aheadOut = ahead + way * speed;
    float under = ahead + slack * depth;
    float underOut = aheadOut + slack * depthOut;

    if (flatBlock && behind && under >= 0.0f) { behind = false; }
    if (flatBlock && !behind && ahead < -kPassed)
    {
      // Hidden from the start: it was lost nearer.
      if (fresh)
      {
        fresh = false;
        t = 0.0f;
        level = first;
        continue;
      }
      behind = true;
      march.lost = max(t - kBeside * texel * depth * depth, 0.0f);
    }
    bool clear = behind ? under < 0.0f && underOut < 0.0f : ahead >= -kOn && aheadOut >= -kOn;
    if (clear && behind && flatBlock && ahead > -kDeep && float(i) + used + 1.0f < steps)
    {
      // Straight in front of it on the plane: is this the visible side?
      vec3 plane = vec3(bound.x, bound.y, bound.z);
      vec3 shade = x + (ahead / max(dot(plane, plane), 1.0e-30f)) * plane;
      vec4 there = fetchProbeRelief(probe, shade, 0.0f);
      used = used + 1.0f;
      if (abs(1.0f - dot(vec3(there.x, there.y, there.z), shade)) < kSame)
      {
        march.met = t;
        break;
      }
    }
    if (clear)
    {
      fresh = false;
      if (next >= farthest)
      {
        t = farthest;
        break;
      }
      t = next;
      // Four times larger blocks only where one starts.
      if (line - 2.0f * floor(0.5f * line) < 0.5f) { level = min(level + 1.0f, top); }
    }
    else
    {
      // To where the bound is exceeded.
      float from = behind ? under : ahead;
      float to = behind ? underOut : aheadOut;
      if (from * to < 0.0f) { t = t + way * from / (from - to); }
      if (flatBlock)
      {
        // Emerges through a side that the probe saw, after entering unseen: that side is the best estimate.
        march.met = t;
        break;
      }
      level = level - 1.0f;
    }
  }
  march.way = t;
  if (!behind) { march.lost = -1.0f; }
  return march;
}
#endif
