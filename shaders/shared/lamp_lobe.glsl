// Glossy light of a lamp, without samples and without tables: the polygon's image among the visible normals. With h = normalize(V + L),
// f cos(L) dL = VNDF(h) G2 / G1 dh exactly, and where the surface is stretched to roughness 1 the visible normals of GGX are a cosine about
// the stretched view (Heitz 2018). So the lamp's share of the lobe is the form factor of its image, great arcs taken for the image of its
// edges once these are split where they pass the mirrored view. Needs lamp.glsl and lobe_frame.glsl. Total, as lamp.glsl is.

// Longest edge, squared, of an image that its corners tell enough of.
const float kLampSmallImage = 0.04f;

// `view`: unit, towards the eye. A view from below the surface counts as one along it.
LampLobe lampLobe(vec3 normal, vec3 view, float roughness)
{
  LampLobe lobe;
  float facing = dot(normal, view);
  float nv = clamp(facing, 1.0e-4f, 1.0f);
  vec3 aside = view - normal * facing;
  float s = length(aside);
  lobe.tangent = s > 1.0e-4f ? aside / s : lobeTangent(normal);  // V along N: any tangent
  lobe.bitangent = cross(normal, lobe.tangent);
  lobe.normal = normal;
  lobe.view = normalize(vec3(s, 0.0f, nv));  // next to N, 1 - nv * nv has no digits left
  float p = clamp(roughness, 0.03f, 1.0f);  // below it a lobe is narrower than rounding allows the image to be
  lobe.alpha = p * p;
  float a2 = lobe.alpha * lobe.alpha;
  lobe.maskView = sqrt(a2 + (1.0f - a2) * lobe.view.z * lobe.view.z);
  lobe.stretched = normalize(vec3(lobe.alpha * lobe.view.x, 0.0f, lobe.view.z));
  lobe.spread = clamp(5.0f * (p - 0.15f), 0.0f, 1.0f);
  return lobe;
}

// G2 / G1 times (1 - s, s) for light from height l.z above the surface, met at a half vector of that cosine with the view.
vec2 lampWeight(LampLobe lobe, float height, float cosine)
{
  float lz = max(height, 0.0f);
  float a2 = lobe.alpha * lobe.alpha;
  float maskLight = sqrt(a2 + (1.0f - a2) * lz * lz);
  float masking = lz * (lobe.view.z + lobe.maskView) / (lobe.view.z * maskLight + lz * lobe.maskView);
  float c = clamp(1.0f - cosine, 0.0f, 1.0f);
  float c2 = c * c;
  float s = c2 * c2 * c;
  return masking * vec2(1.0f - s, s);
}

// The facet that reflects light from direction l, unit, into the view.
LampFacet lampFacetOfLight(LampLobe lobe, vec3 l)
{
  vec3 h = lobe.view + vec3(l.x, l.y, max(l.z, 0.0f));
  LampFacet facet;
  facet.normal = normalize(vec3(h.x, h.y, lobe.alpha * h.z));
  facet.cosine = max(dot(facet.normal, lobe.stretched), 0.0f);
  facet.weight = lampWeight(lobe, l.z, sqrt(max(0.5f + 0.5f * dot(lobe.view, l), 0.0f)));
  return facet;
}

// The facet of a stretched normal, unit.
LampFacet lampFacet(LampLobe lobe, vec3 normal)
{
  vec3 h = vec3(lobe.alpha * normal.x, lobe.alpha * normal.y, normal.z);
  float size = max(length(h), 1.0e-18f);
  float cosine = dot(lobe.view, h) / size;
  LampFacet facet;
  facet.normal = normal;
  facet.cosine = max(dot(normal, lobe.stretched), 0.0f);
  facet.weight = lampWeight(lobe, 2.0f * cosine * h.z / size - lobe.view.z, cosine);
  return facet;
}

// An edge of an image, from one unit vector to another by its offset, because the cross product of nearly equal vectors cancels: the angle
// between them in turns times the unit normal of their plane.
vec3 lampArc(vec3 first, vec3 offset)
{
  vec3 c = cross(first, offset);
  float cosine = 1.0f + dot(first, offset);
  float acute = lampAcuteTurn(min(abs(cosine), 1.0f));
  return (cosine > 0.0f ? acute : 0.5f / sqrt(max(dot(c, c), 1.0e-24f)) - acute) * c;
}

// On to the point in direction l, unit: an edge of the image, and the triangle between it and the pole. A triangle counts by three
// quarters at its middle and the rest at its corners, the rule that is exact for second powers.
LampImage lampImageStep(LampLobe lobe, LampImage image, vec3 l)
{
  LampFacet next = lampFacetOfLight(lobe, l);
  vec3 edge = next.normal - image.last.normal;
  vec3 toPole = image.pole.normal - image.last.normal;
  image.factor += lampArc(image.last.normal, edge);
  vec3 sum = image.last.normal + next.normal + image.pole.normal;
  LampFacet middle = lampFacet(lobe, sum / max(length(sum), 1.0e-18f));
  float area = abs(dot(cross(edge, toPole), middle.normal));
  float atMiddle = 9.0f * area * middle.cosine;
  image.weight += atMiddle * middle.weight + area * (image.last.cosine * image.last.weight + next.cosine * next.weight +
                                                     image.pole.cosine * image.pole.weight);
  image.light += atMiddle + area * (image.last.cosine + next.cosine + image.pole.cosine);
  image.last = next;
  return image;
}

// A corner in the lobe's frame.
vec3 lampInLobe(LampLobe lobe, vec3 corner)
{
  return vec3(dot(corner, lobe.tangent), dot(corner, lobe.bitangent), dot(corner, lobe.normal));
}

vec3 lampToward(vec3 corner)
{
  return corner / max(length(corner), 1.0e-30f);
}

// The way around the polygon, with nothing of its image so far.
LampImage lampImageAbout(LAMP_SLOT lamp, vec3 position, LampLobe lobe)
{
  vec3 middle = lampInLobe(lobe, lampMiddle(lamp) - position);
  LampImage image;
  image.pole = lampFacetOfLight(lobe, lampToward(vec3(middle.x, middle.y, max(middle.z, 0.0f))));
  image.last = image.pole;
  image.factor = vec3(0.0f);
  image.weight = vec2(0.0f);
  image.light = 0.0f;
  return image;
}

// Share of the lobe that an image fills.
float lampImageShare(LampLobe lobe, vec3 factor)
{
  return min(2.0f * abs(dot(factor, lobe.stretched)) / (1.0f + lobe.stretched.z), 1.0f);
}

// All of a lamp's image: three pieces an edge, split where it passes closest to the mirrored view and in the middle of the longer part.
vec2 lampGlossyNear(LAMP_SLOT lamp, vec3 position, LampLobe lobe)
{
  int count = max(lampCornerCount(lamp), 1);
  LampImage image = lampImageAbout(lamp, position, lobe);
  vec3 mirrored = vec3(-lobe.view.x, 0.0f, lobe.view.z);
  vec3 a = lampInLobe(lobe, lampCorner(lamp, count - 1) - position);
  vec3 leaves = vec3(0.0f);  // where the polygon goes below the horizon and where it comes up again
  vec3 enters = vec3(0.0f);
  bool cut = false;
  int i = 0;
  // If it is cut, one edge more, along the horizon. The end is asked for last: software renderers work a turn out before they leave a loop.
  do
  {
    vec3 b = lampInLobe(lobe, lampCorner(lamp, i < count ? i : 0) - position);
    vec3 from = a;
    vec3 to = b;
    if (a.z < 0.0f && b.z >= 0.0f)
    {
      from = lampAtHorizon(b, b.z, a, a.z);
      enters = from;
    }
    if (a.z >= 0.0f && b.z < 0.0f)
    {
      to = lampAtHorizon(a, a.z, b, b.z);
      leaves = to;
    }
    if (i == count)
    {
      from = leaves;
      to = enters;
    }
    bool drawn = i == count || a.z >= 0.0f || b.z >= 0.0f;
    float unit = 1.0f / max(length(from), 1.0e-30f);
    vec3 start = unit * from;
    vec3 end = lampToward(to);
    vec3 d = unit * (to - from);
    float ar = dot(start, mirrored);
    float dr = dot(d, mirrored);
    float ad = dot(start, d);
    float above = ar * ad - dr;
    float dd = dot(d, d);
    float below = dr * ad - ar * dd;
    float t = abs(below) > 1.0e-5f * dd ? clamp(above / below, 0.1f, 0.9f) : 0.5f;  // else all of it is a right angle away
    vec3 split = lampToward(start + t * d);
    bool firstLonger = dot(start, split) < dot(split, end);
    vec3 middle = lampToward(split + (firstLonger ? start : end));
    image.last = lampFacetOfLight(lobe, start);
    int piece = 0;
    do
    {
      vec3 next = (piece == 0) == firstLonger ? middle : split;
      if (drawn) { image = lampImageStep(lobe, image, piece < 2 ? next : end); }
      ++piece;
    } while (piece < 3);
    cut = dot(leaves, leaves) > 0.0f && dot(enters, enters) > 0.0f;
    a = b;
    ++i;
  } while (i < count || (i == count && cut));
  float along = dot(image.factor, lobe.stretched);
  float size = length(image.factor);
  vec2 weight = lampFacet(lobe, (along < 0.0f ? -1.0f : 1.0f) / max(size, 1.0e-20f) * image.factor).weight;
  if (image.light > 1.0e-30f) { weight = mix(weight, image.weight / image.light, lobe.spread); }
  return size > 1.0e-20f ? lampImageShare(lobe, image.factor) * weight : vec2(0.0f);
}

// The way around a polygon by its corners alone.
struct LampCorners
{
  LampImage image;
  float whole;    // sum over the triangles of their area
  float widest;   // of the image's edges, squared
  float lowest;   // corner's sine over the horizon
  float highest;
};

LampCorners lampCornersStep(LampLobe lobe, LampCorners way, vec3 corner)
{
  vec3 l = lampToward(lampInLobe(lobe, corner));
  LampFacet next = lampFacetOfLight(lobe, l);
  LampFacet last = way.image.last;
  vec3 edge = next.normal - last.normal;
  vec3 arc = lampArc(last.normal, edge);
  float area = abs(dot(arc, way.image.pole.normal));
  way.image.factor += arc;
  way.image.weight += area * (last.cosine * last.weight + next.cosine * next.weight);
  way.image.light += area * (last.cosine + next.cosine);
  way.image.last = next;
  way.whole += area;
  way.widest = max(way.widest, dot(edge, edge));
  way.lowest = min(way.lowest, l.z);
  way.highest = max(way.highest, l.z);
  return way;
}

// A lamp whose image is small needs no more than its corners: weights count by two thirds at the middle and the rest at the corners, the
// rule that is exact for second powers over a parallelogram.
LampGlance lampGlossyGlance(LAMP_SLOT lamp, vec3 position, LampLobe lobe)
{
  int count = max(lampCornerCount(lamp), 1);
  LampCorners way;
  way.image = lampImageAbout(lamp, position, lobe);
  way.image.last = lampFacetOfLight(lobe, lampToward(lampInLobe(lobe, lampCorner(lamp, count - 1) - position)));
  way.whole = 0.0f;
  way.widest = 0.0f;
  way.lowest = 1.0f;
  way.highest = -1.0f;
  // By fours, the last corner again and again where there are no more: software renderers pay for each turn of a loop.
  int i = 0;
  do
  {
    way = lampCornersStep(lobe, way, lampCorner(lamp, min(i, count - 1)) - position);
    way = lampCornersStep(lobe, way, lampCorner(lamp, min(i + 1, count - 1)) - position);
    way = lampCornersStep(lobe, way, lampCorner(lamp, min(i + 2, count - 1)) - position);
    way = lampCornersStep(lobe, way, lampCorner(lamp, min(i + 3, count - 1)) - position);
    i += 4;
  } while (i < count);
  float atMiddle = 4.0f * way.whole * way.image.pole.cosine;
  float light = way.image.light + atMiddle;
  vec2 weight = (way.image.weight + atMiddle * way.image.pole.weight) / max(light, 1.0e-30f);
  bool seen = way.highest >= 0.0f && lampSide(lamp, position) != 0.0f;
  LampGlance glance;
  glance.tooNear = seen && (way.lowest < 0.0f || way.widest > kLampSmallImage);
  glance.light = seen ? lampImageShare(lobe, way.image.factor) * weight : vec2(0.0f);
  return glance;
}

// What a surface reflects of the lamp, GGX with height-correlated masking and Schlick's reflectance: F0 times x plus F90 times y.
// x + y, 0 to 1, is what a surface reflects that reflects all.
vec2 lampGlossy(LAMP_SLOT lamp, vec3 position, LampLobe lobe)
{
  LampGlance glance = lampGlossyGlance(lamp, position, lobe);
  return glance.tooNear ? lampGlossyNear(lamp, position, lobe) : glance.light;
}
