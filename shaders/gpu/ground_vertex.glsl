// A triangle that holds the plane of the ground's shadow, which runs from (0, 0) to (1, 1) in it.
uniform mat4 bpClipFromEye;  // of points relative to the eye, world axes
uniform vec3 bpLow;          // corner of low x and low z, relative to the eye
uniform vec2 bpPlaneSize;    // along x and z
out vec2 bpPlace;

void main()
{
  bpPlace = vec2(gl_VertexID == 1 ? 2.0f : 0.0f, gl_VertexID == 2 ? 2.0f : 0.0f);
  gl_Position = bpClipFromEye * vec4(bpLow + vec3(bpPlace.x * bpPlaneSize.x, 0.0f, bpPlace.y * bpPlaneSize.y), 1.0f);
}
