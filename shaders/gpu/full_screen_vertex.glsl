// One triangle that covers the viewport; texCoord runs from 0 to 1 across it.
out vec2 texCoord;

void main()
{
  texCoord = vec2(gl_VertexID == 1 ? 2.0f : 0.0f, gl_VertexID == 2 ? 2.0f : 0.0f);
  gl_Position = vec4(2.0f * texCoord - 1.0f, 0.0f, 1.0f);
}
