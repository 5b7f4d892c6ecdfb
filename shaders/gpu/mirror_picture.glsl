// Samples a planar mirror's picture; follows shared/mirror_types.glsl, and precedes shared/planar_mirror.glsl.
uniform sampler2D bpMirrorColor;
uniform sampler2D bpMirrorHeight;
uniform float bpMirrorOn;  // 0: there is no picture for this draw
uniform vec4 bpMirrorPlaces[3];
uniform vec4 bpMirrorNormal;   // w: farHeight
uniform vec4 bpMirrorEye;      // w: texelSize
uniform vec3 bpMirrorLevels;   // parallel, maxLevel, sharpLevel
uniform vec2 bpMirrorSize;     // texels

MirrorLook bpMirrorLook()
{
  MirrorLook look;
  look.toU = bpMirrorPlaces[0];
  look.toV = bpMirrorPlaces[1];
  look.toW = bpMirrorPlaces[2];
  look.normal = bpMirrorNormal.xyz;
  look.farHeight = bpMirrorNormal.w;
  look.eye = bpMirrorEye.xyz;
  look.texelSize = bpMirrorEye.w;
  look.parallel = bpMirrorLevels.x;
  look.maxLevel = bpMirrorLevels.y;
  look.sharpLevel = bpMirrorLevels.z;
  look.sizeX = bpMirrorSize.x;
  look.sizeY = bpMirrorSize.y;
  look.picture = 0;
  return look;
}

vec4 fetchMirrorColor(MirrorLook look, vec2 place, float level)
{
  return textureLod(bpMirrorColor, place, level);
}

vec4 fetchMirrorHeight(MirrorLook look, vec2 place, float level)
{
  return textureLod(bpMirrorHeight, place, level);
}
