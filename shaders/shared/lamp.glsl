// Diffuse light of a lamp on a surface. The lamp is a flat convex polygon that shines evenly: radiance 1 here. The form factor of a
// polygon is exact (Lambert 1760; Baum, Rushmeier and Winget 1989). Needs lamp_types.glsl; the host supplies, by LAMP_SLOT,
//   int lampCornerCount(LAMP_SLOT lamp)         3 to kLampCorners
//   vec3 lampCorner(LAMP_SLOT lamp, int i)      counterclockwise as the shining side is seen; the frame of the position
//   vec3 lampMiddle(LAMP_SLOT lamp)             mean of the corners
//   vec4 lampPlane(LAMP_SLOT lamp)              lampPlaneThrough the first three
//   bool lampShinesBothSides(LAMP_SLOT lamp)
//
// Total: for finite input the result is finite.

// On which side of the lamp a position lies: 1 on the shining one, -1 behind a lamp that shines both ways, else 0. A position in the
// lamp's plane sees none of it.
float lampSide(LAMP_SLOT lamp, vec3 position)
{
  vec4 plane = lampPlane(lamp);
  float height = dot(vec3(plane), position) + plane.w;
  float side = height > 1.0f ? 1.0f : (height < -1.0f ? -1.0f : 0.0f);
  return lampShinesBothSides(lamp) ? side : max(side, 0.0f);
}

// Where the edge from a point above the horizon to one below it meets the horizon.
vec3 lampAtHorizon(vec3 above, float heightAbove, vec3 below, float heightBelow)
{
  return above + (heightAbove / max(heightAbove - heightBelow, 1.0e-30f)) * (below - above);
}

// The way along a polygon's edges, so far.
struct LampOutline
{
  vec3 from;      // corner reached last, relative to the position, in units of the last corner's distance, so that products stay within
  float height;   // a float's range; its height above the horizon
  float square;   // of its distance
  float sum;      // over edges, as far as they are above the horizon: angle in turns times the cosine of their plane's normal
  vec3 leaves;    // directions where the polygon goes below the horizon and where it comes up again; 0: it does not
  vec3 enters;
};

// An angle of at most a right one, in turns over its sine, by its cosine, within 2e-6 of it; atan costs software renderers three times as
// much.
float lampAcuteTurn(float cosine)
{
  return (0.8543985f + (0.4965155f + 0.0145206f * cosine) * cosine) / (3.417594f + (4.1616724f + cosine) * cosine);
}

// The same of any angle up to half a turn.
float lampTurnOverSine(float cosine)
{
  float x = min(abs(cosine), 1.0f);
  float acute = lampAcuteTurn(x);
  return cosine > 0.0f ? acute : 0.5f / sqrt(max(1.0f - x * x, 1.0e-12f)) - acute;
}

// Adds the edge to the corner `to`, in the frame and the units of the way. An edge that is cut by the horizon ends where it crosses it, a
// share of one end's direction and of the other's; its plane stays.
LampOutline lampAlong(LampOutline way, vec3 to, vec3 normal)
{
  float height = dot(to, normal);
  float square = dot(to, to);
  bool fromAbove = way.height >= 0.0f;
  bool toAbove = height >= 0.0f;
  vec3 plane = cross(way.from, to - way.from);  // by the offset, because the cross product of nearly equal vectors cancels
  float share = fromAbove ? (toAbove ? 1.0f : way.height) : height;
  float beyond = fromAbove ? (toAbove ? 0.0f : height * way.square) : way.height * square;
  float c = share * dot(way.from, to) - beyond;
  float unit = 1.0f / sqrt(max(c * c + share * share * dot(plane, plane), 1.0e-36f));
  way.sum += fromAbove || toAbove ? lampTurnOverSine(c * unit) * share * unit * dot(plane, normal) : 0.0f;
  vec3 crossing = way.height * to - height * way.from;
  way.leaves = fromAbove && !toAbove ? crossing : way.leaves;
  way.enters = toAbove && !fromAbove ? crossing : way.enters;
  way.from = to;
  way.height = height;
  way.square = square;
  return way;
}

// Irradiance over pi at `position`: the share of the hemisphere's cosine about the unit `normal` that the lamp fills, 0 to 1.
float lampDiffuse(LAMP_SLOT lamp, vec3 position, vec3 normal)
{
  int count = max(lampCornerCount(lamp), 1);
  LampOutline way;
  way.from = lampCorner(lamp, count - 1) - position;
  float unit = 1.0f / sqrt(max(dot(way.from, way.from), 1.0e-36f));
  way.from = unit * way.from;
  way.square = dot(way.from, way.from);
  way.height = dot(way.from, normal);
  way.sum = 0.0f;
  way.leaves = vec3(0.0f);
  way.enters = vec3(0.0f);
  // By fours, the last corner again and again where there are no more: software renderers pay for each turn of a loop.
  int i = 0;
  do
  {
    way = lampAlong(way, unit * (lampCorner(lamp, min(i, count - 1)) - position), normal);
    way = lampAlong(way, unit * (lampCorner(lamp, min(i + 1, count - 1)) - position), normal);
    way = lampAlong(way, unit * (lampCorner(lamp, min(i + 2, count - 1)) - position), normal);
    way = lampAlong(way, unit * (lampCorner(lamp, min(i + 3, count - 1)) - position), normal);
    i += 4;
  } while (i < count);
  // The arc that closes it along the horizon, less than half a turn, in the direction of the others.
  float sizes = dot(way.leaves, way.leaves) * dot(way.enters, way.enters);
  float size = 1.0f / sqrt(max(sizes, 1.0e-36f));
  float cosine = -size * dot(way.leaves, way.enters);
  float acute = size * abs(dot(normal, cross(way.leaves, way.enters))) * lampAcuteTurn(min(abs(cosine), 1.0f));
  float closing = cosine > 0.0f ? acute : 0.5f - acute;
  bool cut = sizes > 0.0f;
  float side = lampSide(lamp, position);
  return side == 0.0f ? 0.0f : clamp((cut ? closing : 0.0f) - side * way.sum, 0.0f, 1.0f);
}
