// The cubemap's frame: OpenGL's face order +X -X +Y -Y +Z -Z and orientation within a face (OpenGL 4.5, table 8.19).

// Direction through the point (s, t) of a face, both in [-1, 1], s along the texture's columns, t along its rows. Not
// normalised: its largest component is 1.
vec3 cubeDirection(int face, float s, float t)
{
  if (face == 0) { return vec3(1.0f, -t, -s); }
  if (face == 1) { return vec3(-1.0f, -t, s); }
  if (face == 2) { return vec3(s, 1.0f, t); }
  if (face == 3) { return vec3(s, -1.0f, -t); }
  if (face == 4) { return vec3(s, -t, 1.0f); }
  return vec3(-s, -t, -1.0f);
}

// Direction to the centre of the texel that a direction falls into, for faces of `faceSize`² texels; its largest
// component is 1. The grid is the same on all faces, so the face need not be known.
vec3 cubeTexelCentre(vec3 direction, float faceSize)
{
  vec3 a = abs(direction);
  float largest = max(max(a.x, a.y), max(a.z, 1.0e-37f));
  vec3 q = direction / largest;
  vec3 last = vec3(faceSize - 1.0f);
  vec3 texel = clamp(floor((0.5f * q + 0.5f) * faceSize), vec3(0.0f), last);
  vec3 centre = (2.0f * texel + 1.0f) / faceSize - 1.0f;
  if (a.x >= a.y && a.x >= a.z) { centre.x = direction.x < 0.0f ? -1.0f : 1.0f; }
  else if (a.y >= a.z) { centre.y = direction.y < 0.0f ? -1.0f : 1.0f; }
  else { centre.z = direction.z < 0.0f ? -1.0f : 1.0f; }
  return centre;
}

// Index of the cell that a direction falls into, for faces of `faceSize`² cells: faces in order, row by row.
int cubeCell(vec3 direction, int faceSize)
{
  vec3 a = abs(direction);
  float largest = max(max(a.x, a.y), max(a.z, 1.0e-37f));
  vec3 d = direction / largest;
  int face = d.z < 0.0f ? 5 : 4;
  float s = d.z < 0.0f ? -d.x : d.x;
  float t = -d.y;
  if (a.x >= a.y && a.x >= a.z)
  {
    face = d.x < 0.0f ? 1 : 0;
    s = d.x < 0.0f ? d.z : -d.z;
  }
  else if (a.y >= a.z)
  {
    face = d.y < 0.0f ? 3 : 2;
    s = d.x;
    t = d.y < 0.0f ? -d.z : d.z;
  }
  float size = float(faceSize);
  int column = int(clamp((0.5f * s + 0.5f) * size, 0.0f, size - 1.0f));
  int row = int(clamp((0.5f * t + 0.5f) * size, 0.0f, size - 1.0f));
  return (face * faceSize + row) * faceSize + column;
}
