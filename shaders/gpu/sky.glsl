// The sky behind everything. Alpha 0: a capture's alpha says where geometry was. Needs shared/sky.glsl.
uniform int bpSkyKind;         // 0: gradient, 1: latitude-longitude image
uniform vec3 bpSkyTop;
uniform vec3 bpSkyHorizon;
uniform vec3 bpSkyGround;
uniform sampler2D bpSkyImage;  // first row at the top of the picture; centre column looks along +Z of OpenEXR's convention
uniform mat3 bpViewToWorld;
uniform vec2 bpTangents;       // tangent of half the field of view, horizontal and vertical
uniform float bpParallel;      // 1: parallel projection, one direction for every pixel
uniform float bpExposure;      // negative: linear output; else display colours at this exposure

in vec2 texCoord;

void main()
{
  vec2 p = (2.0f * texCoord - 1.0f) * bpTangents * (1.0f - bpParallel);
  vec3 d = bpViewToWorld * normalize(vec3(p, -1.0f));
  vec3 color;
  if (bpSkyKind == 1)
  {
    // OpenEXR's latitude-longitude map: longitude pi at the left edge, 0 along +z in the middle, latitude pi/2 on top.
    float longitude = atan(d.x, d.z);
    float latitude = asin(clamp(d.y, -1.0f, 1.0f));
    color = textureLod(bpSkyImage, vec2(0.5f - longitude / 6.2831853f, 0.5f - latitude / 3.1415927f), 0.0f).rgb;
  }
  else
  {
    color = skyGradient(d, bpSkyTop, bpSkyHorizon, bpSkyGround);
  }
  gl_FragData[0] = vec4(bpExposure >= 0.0f ? pow(color * bpExposure, vec3(1.0f / 2.2f)) : color, 0.0f);
}
