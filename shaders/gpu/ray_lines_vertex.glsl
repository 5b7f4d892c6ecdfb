// A line of constant width in pixels as a rectangle facing the screen: one instance per line, four vertices each. The
// ends are projected here, so a moved camera uploads only two matrices.
in vec3 bpFrom;    // relative to the lines' anchor, which was subtracted in double
in vec3 bpTo;
in vec3 bpColor;
in vec2 bpShape;   // width in pixels; 1: the shaft of an arrow, 2: its head

uniform mat4 bpClipFromLine;
uniform mat4 bpPulledFromLine;  // the same slightly nearer to the eye: only its depth is used, so that a line on a wall is in front of it
uniform vec2 bpHalfViewport;   // pixels
uniform float bpNear;  // view depth at which a line is clipped; negative in parallel projection: none
uniform float bpPixelScale;  // device pixels per logical pixel

out vec2 place;                // pixels along and across, 0 at the start
flat out float lineLength;     // pixels
flat out vec3 lineColor;
flat out vec2 lineShape;       // half width in pixels; 1 or 2: of an arrow

// Margin in pixels beyond the ends and sides for halo and smooth edge. Arrowheads are wider and have separate
// rectangles, so that long shafts stay narrow: the cost is the covered pixels.
const float kReach = 3.0f;
const float kHeadReach = 7.0f;
const float kHeadLength = 14.0f;

void main()
{
  vec4 a = bpClipFromLine * vec4(bpFrom, 1.0f);
  vec4 b = bpClipFromLine * vec4(bpTo, 1.0f);
  vec4 pulledA = bpPulledFromLine * vec4(bpFrom, 1.0f);
  vec4 pulledB = bpPulledFromLine * vec4(bpTo, 1.0f);
  place = vec2(0.0f);
  lineLength = 0.0f;
  lineColor = bpColor;
  lineShape = vec2(0.5f * bpShape.x * bpPixelScale, bpShape.y);
  // Points behind the eye cannot be projected: clips the part in front of `bpNear`.
  if (a.w < bpNear && b.w < bpNear) { gl_Position = vec4(0.0f, 0.0f, 2.0f, 1.0f); return; }
  if (a.w < bpNear)
  {
    float t = (bpNear - a.w) / (b.w - a.w);
    a = mix(a, b, t);
    pulledA = mix(pulledA, pulledB, t);
  }
  else if (b.w < bpNear)
  {
    float t = (bpNear - b.w) / (a.w - b.w);
    b = mix(b, a, t);
    pulledB = mix(pulledB, pulledA, t);
  }
  vec2 start = a.xy / a.w * bpHalfViewport;
  vec2 end = b.xy / b.w * bpHalfViewport;
  vec2 along = end - start;
  lineLength = length(along);
  along = lineLength > 1.0e-3f ? along / lineLength : vec2(1.0f, 0.0f);
  vec2 across = vec2(-along.y, along.x);
  bool head = lineShape.y > 1.5f;
  float reach = lineShape.x + (head ? kHeadReach : kReach) * bpPixelScale;
  float first = head ? max(lineLength - kHeadLength * bpPixelScale, 0.0f) : -reach;
  bool atEnd = (gl_VertexID & 1) == 1;
  float side = (gl_VertexID & 2) == 2 ? reach : -reach;
  vec2 corner = (atEnd ? end + reach * along : start + first * along) + side * across;
  place = vec2(atEnd ? lineLength + reach : first, side);
  // w = 1: depth and place are linear on the screen.
  float depth = atEnd ? pulledB.z / pulledB.w : pulledA.z / pulledA.w;
  gl_Position = vec4(corner / bpHalfViewport, depth, 1.0f);
}
