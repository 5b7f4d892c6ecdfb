// Positions only, for a depth map.
in vec3 bpPosition;
uniform mat4 bpClipFromModel;

void main()
{
  gl_Position = bpClipFromModel * vec4(bpPosition, 1.0);
}
