// A line's fragments: a bright core in a dark halo, visible on bright and dark walls, with smooth edges by the distance
// to its outline.
in vec2 place;
flat in float lineLength;
flat in vec3 lineColor;
flat in vec2 lineShape;

uniform int bpPart;  // 0: hidden parts, dashed and faint; 1: halo; 2: core
uniform float bpPixelScale;

const float kHaloPixels = 1.75f;
const vec3 kHaloColor = vec3(0.04f);
const float kDashPixels = 9.0f; // a dash and its gap

// Distance in pixels to the outline of a line with round ends, or of an arrow's head; negative inside.
float outline()
{
  float head = 11.0f * bpPixelScale;
  float headHalf = 4.5f * bpPixelScale;
  bool arrow = lineShape.y > 0.5f && lineLength > 1.5f * head;
  float end = arrow ? lineLength - 0.5f * head : lineLength;
  float beyond = max(max(-place.x, place.x - end), 0.0f);
  if (lineShape.y < 1.5f) { return length(vec2(beyond, place.y)) - lineShape.x; }
  if (!arrow) { return 1.0e6f; }  // too short on the screen for an arrowhead
  vec2 q = vec2(lineLength - place.x, abs(place.y));  // from the tip backwards
  return max(dot(q, normalize(vec2(-headHalf, head))), q.x - head);
}

void main()
{
  float d = outline();
  float halo = clamp(0.5f + kHaloPixels * bpPixelScale - d, 0.0f, 1.0f);
  float core = clamp(0.5f - d, 0.0f, 1.0f);
  if (halo <= 0.0f) { discard; }
  if (bpPart == 0)
  {
    if (lineLength > 0.5f && fract(place.x / (kDashPixels * bpPixelScale)) > 0.55f) { discard; }
    gl_FragData[0] = vec4(mix(kHaloColor, lineColor, core), max(0.55f * core, 0.3f * halo));
  }
  else if (bpPart == 1) { gl_FragData[0] = vec4(kHaloColor, 0.75f * halo); }
  else
  {
    if (core <= 0.0f) { discard; }
    gl_FragData[0] = vec4(lineColor, core);
  }
}
