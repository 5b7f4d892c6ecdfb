// A vertex of a browser's scene, which holds world positions.
uniform mat4 bpClipFromWorld;

in vec3 bpVertexPosition;
in vec3 bpVertexNormal;
in vec2 bpVertexUv;
out vec3 bpPosition;
out vec3 bpNormal;
out vec2 bpUv;

void main()
{
  bpPosition = bpVertexPosition;
  bpNormal = bpVertexNormal;
  bpUv = bpVertexUv;
  gl_Position = bpClipFromWorld * vec4(bpVertexPosition, 1.0f);
}
