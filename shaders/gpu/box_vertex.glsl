// A box for an occlusion query, from vertex numbers: 12 triangles without a buffer.
uniform mat4 bpClipFromEye;  // of points relative to the eye, world axes
uniform vec3 bpLow;
uniform vec3 bpHigh;

void main()
{
  // Each face is two triangles of four corners; the axis of the face is gl_VertexID / 12.
  int face = gl_VertexID / 6;
  int corner = gl_VertexID % 6;
  int u = (corner == 1 || corner == 2 || corner == 4) ? 1 : 0;
  int v = (corner == 2 || corner == 4 || corner == 5) ? 1 : 0;
  int axis = face / 2;
  ivec3 bits = axis == 0 ? ivec3(face % 2, u, v) : axis == 1 ? ivec3(u, face % 2, v) : ivec3(u, v, face % 2);
  gl_Position = bpClipFromEye * vec4(mix(bpLow, bpHigh, vec3(bits)), 1.0);
}
