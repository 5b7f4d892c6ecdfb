// For depth-only draws: a shadow map, or an occlusion query.
void main()
{
  gl_FragData[0] = vec4(0.0f);
}
