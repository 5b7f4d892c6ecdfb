// Records the lookups of a draw for the debug view. Only in programs compiled for the debug view; spliced in before
// gpu/fetch_probe.glsl. The numbers are those of filters/core/scene/surface_view.cpp.
uniform int bpView;            // row of surfaceViews(); 0: the picture itself
uniform vec3 bpSkyColor;  // represents the sky's share in the view of weights
struct BpTrace
{
  float share;        // of the pixel; the probe with the largest one is shown
  ProbeHit hit;       // along R
  float trueDistance;  // along R; kNoHit if the probe's distances do not contain it
  vec3 truth;         // P - C + trueDistance R, world axes
  vec3 lookup;  // sampled direction, world axes
  float levelSum;
  float fetches;
  float maxLevel;
};

BpTrace bpBest;
vec3 bpWeightColor = vec3(0.0f);
vec3 bpDiffuseLight = vec3(-1.0f); // irradiance over pi
float bpNodeShare = 0.0f;  // of the pixel, of probes with a lattice
float bpNodeKnown = 0.0f;  // the part of it whose nodes are valid
float bpLookups = 0.0f;    // of the pixel
float bpLevelSum = 0.0f;   // of the probe being evaluated
float bpFetches = 0.0f;
bool bpCoat = false;  // the clear coat's lookups count, but its probes are not shown

// First in the source as well: drivers warn of variables that look uninitialized.
void bpTraceNothing()
{
  bpBest.share = 0.0f;
  bpBest.fetches = 0.0f;
}

void bpTraceFetch(float level, float maxLevel)
{
  bpLookups += 1.0f;
  bpFetches += 1.0f;
  bpLevelSum += clamp(level, 0.0f, maxLevel);
}
