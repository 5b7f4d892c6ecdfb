// The cube map's frame: OpenGL's face order +X -X +Y -Y +Z -Z and its orientation within a face (OpenGL 4.5, table 8.19).

// Direction through the point (s, t) of a face, both in [-1, 1], s along the texture's columns, t along its rows.
// Not normalised: its largest component is 1.
vec3 cubeDirection(int face, float s, float t)
{
  if (face == 0) { return vec3(1.0f, -t, -s); }
  if (face == 1) { return vec3(-1.0f, -t, s); }
  if (face == 2) { return vec3(s, 1.0f, t); }
  if (face == 3) { return vec3(s, -1.0f, -t); }
  if (face == 4) { return vec3(s, -t, 1.0f); }
  return vec3(-s, -t, -1.0f);
}
