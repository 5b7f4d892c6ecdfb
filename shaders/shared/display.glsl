// From linear light, 1 being the white of a display, to what the display is sent: the transfer curve of sRGB (IEC 61966-2-1), by which
// textures are decoded, so that an unlit texel returns as the byte it was stored as.
float srgbEncoded(float light)
{
  return light <= 0.0031308f ? 12.92f * light : 1.055f * pow(light, 1.0f / 2.4f) - 0.055f;
}

vec3 srgbEncoded(vec3 light)
{
  return vec3(srgbEncoded(light.x), srgbEncoded(light.y), srgbEncoded(light.z));
}

// And back.
float srgbDecoded(float shown)
{
  return shown <= 0.04045f ? shown / 12.92f : pow((shown + 0.055f) / 1.055f, 2.4f);
}

vec3 srgbDecoded(vec3 shown)
{
  return vec3(srgbDecoded(shown.x), srgbDecoded(shown.y), srgbDecoded(shown.z));
}
