// A lamp of the scene: a flat convex polygon that shines evenly. World space, scene units.
struct BoxprobeLamp
{
  vec3 corners[kLampCorners];  // counterclockwise as the shining side is seen
  int count;                   // of them
  bool bothSides;
  vec3 radiance;
};

int lampCornerCount(BoxprobeLamp lamp)
{
  return lamp.count;
}

vec3 lampCorner(BoxprobeLamp lamp, int i)
{
  return lamp.corners[i];
}

vec4 lampPlane(BoxprobeLamp lamp)
{
  return lampPlaneThrough(lamp.corners[0], lamp.corners[1], lamp.corners[2]);
}

bool lampShinesBothSides(BoxprobeLamp lamp)
{
  return lamp.bothSides;
}
