// The sky behind everything. Alpha 0: a capture's alpha says where geometry was. Needs shared/sky.glsl, gpu/output_uniforms.glsl and
// gpu/output.glsl.
//   BP_PLAIN       defined for a grey backdrop, brighter in the middle
//   BP_ONE_COLOR   defined for one colour
//   BP_SKY_MAP     defined for a level of the sky's map along the world's axes
//   BP_SKY_IMAGE   defined if the sky is a picture; none of them: it is a gradient
//   BP_SKY_SUN     with BP_SKY_IMAGE: defined for the disc of a sun that is drawn as a light
uniform vec3 bpSunTowards;     // unit length, in the picture's frame
uniform float bpSunRadius;     // length of the chord from its middle to its edge
uniform vec3 bpSunRadiance;
uniform vec3 bpSkyTop;
uniform vec3 bpSkyHorizon;
uniform vec3 bpSkyGround;
uniform samplerCube bpSkyMap;  // the sky as probes' programs look it up
uniform float bpSkyLevel;
uniform vec2 bpPixelSize;      // of the picture, 1 being all of it
uniform float bpPlainLight;    // light that is shown as white
uniform vec3 bpColor;          // light that is shown as the colour that was asked for
uniform sampler2D bpSkyImage;  // first row at the top of the picture; centre column looks along +Z of OpenEXR's convention

in vec3 bpDirection;

void main()
{
#if defined(BP_PLAIN)
  float away = length((gl_FragCoord.xy * bpPixelSize - 0.5f) * vec2(1.0f, 0.8f));
  vec3 color = vec3(bpPlainLight * srgbDecoded(mix(0.62f, 0.30f, smoothstep(0.05f, 0.65f, away))));
#elif defined(BP_ONE_COLOR)
  vec3 color = bpColor;
#elif defined(BP_SKY_MAP)
  vec3 color = textureLod(bpSkyMap, normalize(bpDirection), bpSkyLevel).rgb;
#elif defined(BP_SKY_IMAGE)
  // OpenEXR's latitude-longitude map: longitude pi at the left edge, 0 along +z in the middle, latitude pi/2 on top.
  vec3 d = normalize(bpDirection);
  float longitude = atan(d.x, d.z);
  float latitude = asin(clamp(d.y, -1.0f, 1.0f));
  vec3 color = textureLod(bpSkyImage, vec2(0.5f - longitude / 6.2831853f, 0.5f - latitude / 3.1415927f), 0.0f).rgb;
#if defined(BP_SKY_SUN)
  color += distance(d, bpSunTowards) < bpSunRadius ? bpSunRadiance : vec3(0.0f);
#endif
#else
  vec3 color = skyGradient(bpDirection, bpSkyTop, bpSkyHorizon, bpSkyGround);
#endif
  gl_FragData[0] = vec4(bpOutput(color), 0.0f);
}
