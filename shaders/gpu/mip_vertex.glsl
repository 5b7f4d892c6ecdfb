// A quad that covers the viewport, as a fan; texCoord runs from 0 to 1 across it. Unlike the single triangle of
// full_screen_vertex, its corners give the same coordinates, and so texels, as Mesa's own mip levels.
out vec2 texCoord;

void main()
{
  texCoord = vec2(gl_VertexID == 1 || gl_VertexID == 2 ? 1.0f : 0.0f, gl_VertexID >= 2 ? 1.0f : 0.0f);
  gl_Position = vec4(2.0f * texCoord - 1.0f, 0.0f, 1.0f);
}
