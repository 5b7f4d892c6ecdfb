// What a browser's scene shows where nothing stands, along the unit direction of a pixel. Needs shared/sky.glsl and display.glsl.
uniform vec3 bpSkyTop;
uniform vec3 bpSkyHorizon;
uniform vec3 bpSkyGround;
uniform samplerCube bpSkyMap;
uniform float bpSkyPicture;  // 1: the map's sharpest level, not the gradient
uniform float bpExposure;
uniform mat3 bpWorldFromView;
uniform vec2 bpTangents;     // of half the field of view
in vec2 texCoord;
out vec4 bpColor;

void main()
{
  vec3 d = normalize(bpWorldFromView * vec3((2.0f * texCoord - 1.0f) * bpTangents, -1.0f));
  vec3 color = bpSkyPicture > 0.5f ? textureLod(bpSkyMap, d, 0.0f).rgb : skyGradient(d, bpSkyTop, bpSkyHorizon, bpSkyGround);
  bpColor = vec4(bpExposure >= 0.0f ? srgbEncoded(BP_TONE(color * bpExposure)) : color, 0.0f);
}
