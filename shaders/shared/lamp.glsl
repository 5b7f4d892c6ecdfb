// Diffuse light of a lamp on a surface. The lamp is a flat convex polygon that shines evenly: radiance 1 here. The form factor of a
// polygon is exact (Lambert 1760; Baum, Rushmeier and Winget 1989). Needs lamp_types.glsl; the host supplies, by LAMP_SLOT,
//   int lampCornerCount(LAMP_SLOT lamp)         3 to kLampCorners
//   vec3 lampCorner(LAMP_SLOT lamp, int i)      counterclockwise as the shining side is seen; the frame of the position
//   bool lampShinesBothSides(LAMP_SLOT lamp)
//
// Total: for finite input the result is finite.

const float kLampPerTurn = 0.15915494f;  // 1 / (2 pi)

// Of the edge between two points, first as a unit vector and the second by its offset, in lengths of the first: the angle between them
// times the unit normal of their plane. By the offset, because the cross product of nearly equal vectors cancels.
vec3 lampEdge(vec3 first, vec3 offset)
{
  vec3 c = cross(first, offset);
  float sine = length(c);
  return sine > 1.0e-18f ? atan(sine, 1.0f + dot(first, offset)) / sine * c : vec3(0.0f);
}

// On which side of the lamp a position lies: 1 on the shining one, -1 behind a lamp that shines both ways, else 0. A position in the
// lamp's plane sees none of it; the least height, 1e-5 of the lamp's size, is above rounding.
float lampSide(LAMP_SLOT lamp, vec3 position)
{
  vec3 a = lampCorner(lamp, 0);
  vec3 along = lampCorner(lamp, 1) - a;
  vec3 up = lampCorner(lamp, 2) - a;
  vec3 n = cross(along, up);
  float height = dot(n, position - a);
  float least = 1.0e-5f * length(n) * (length(along) + length(up));
  if (height > least) { return 1.0f; }
  return height < -least && lampShinesBothSides(lamp) ? -1.0f : 0.0f;
}

// Where the edge from a point above the horizon to one below it meets the horizon.
vec3 lampAtHorizon(vec3 above, float heightAbove, vec3 below, float heightBelow)
{
  return above + (heightAbove / max(heightAbove - heightBelow, 1.0e-30f)) * (below - above);
}

// Irradiance over pi at `position`: the share of the hemisphere's cosine about the unit `normal` that the lamp fills, 0 to 1.
float lampDiffuse(LAMP_SLOT lamp, vec3 position, vec3 normal)
{
  float side = lampSide(lamp, position);
  // No corner of a lamp that is not seen: software renderers work out both sides of a branch, and leave a loop that has ended.
  int count = side == 0.0f ? 0 : lampCornerCount(lamp);
  vec3 a = lampCorner(lamp, max(count - 1, 0)) - position;
  float heightA = dot(a, normal);
  float sum = 0.0f;
  vec3 leaves = vec3(0.0f);  // where the polygon goes below the horizon and where it comes up again
  vec3 enters = vec3(0.0f);
  for (int i = 0; i < count; ++i)
  {
    vec3 b = lampCorner(lamp, i) - position;
    float heightB = dot(b, normal);
    if (heightA >= 0.0f || heightB >= 0.0f)
    {
      vec3 from = a;
      vec3 to = b;
      if (heightA < 0.0f)
      {
        from = lampAtHorizon(b, heightB, a, heightA);
        enters = from;
      }
      if (heightB < 0.0f)
      {
        to = lampAtHorizon(a, heightA, b, heightB);
        leaves = to;
      }
      float unit = 1.0f / max(length(from), 1.0e-30f);
      sum += dot(lampEdge(unit * from, unit * (to - from)), normal);
    }
    a = b;
    heightA = heightB;
  }
  // The arc that closes it along the horizon, less than half a turn, in the direction of the others.
  float closing = abs(atan(dot(normal, cross(leaves, enters)), dot(leaves, enters)));
  bool cut = dot(leaves, leaves) > 0.0f && dot(enters, enters) > 0.0f;
  return clamp(kLampPerTurn * ((cut ? closing : 0.0f) - side * sum), 0.0f, 1.0f);
}
