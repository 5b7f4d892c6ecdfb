// Darkens what is on the screen where the ground would get less of the sky's light. In display colours, whatever their curve: a share of
// the light is about its root of the power 2.2 there.
uniform sampler2D bpGroundLight;
in vec2 bpPlace;

void main()
{
  if (bpPlace.x > 1.0f || bpPlace.y > 1.0f) { discard; }
  float light = clamp(texture(bpGroundLight, bpPlace).r, 0.0f, 1.0f);
  gl_FragData[0] = vec4(0.0f, 0.0f, 0.0f, 1.0f - pow(light, 1.0f / 2.2f));
}
