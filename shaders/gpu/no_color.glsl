// Where depth alone counts: a shadow map, or whether anything passes the depth test.
void main()
{
  gl_FragData[0] = vec4(0.0f);
}
