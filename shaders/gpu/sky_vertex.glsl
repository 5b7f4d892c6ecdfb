// As full_screen_vertex.glsl, with the direction that each point of the picture looks in.
uniform mat3 bpSkyFromView;  // to the axes of the sky
uniform vec2 bpTangents;     // of half the field of view, horizontal and vertical; 0 under parallel projection: one direction everywhere
out vec3 bpDirection;        // axes of the sky, not normalised: as such it is linear across the picture

void main()
{
  vec2 p = vec2(gl_VertexID == 1 ? 3.0f : -1.0f, gl_VertexID == 2 ? 3.0f : -1.0f);
  bpDirection = bpSkyFromView * vec3(p * bpTangents, -1.0f);
  gl_Position = vec4(p, 0.0f, 1.0f);
}
