// The inputs of a lookup in a planar mirror's picture; see planar_mirror.glsl. MIRROR_PICTURE identifies the picture.
struct MirrorLook
{
  vec4 toU;  // these three project a position (relative to the eye, world axes; and 1): u and v from 0 to 1,
  vec4 toV;           //   before division by
  vec4 toW;           //   this
  vec3 normal;        // of the mirror, unit, world axes, on the reflecting side
  float farHeight;  // over the mirror's plane, scene units: heights in the picture are relative to it
  vec3 eye;           // the mirrored eye, relative to the eye, world axes
  float texelSize;    // of the finest level: at distance 1 from the mirrored eye, or anywhere under parallel projection
  float parallel;     // 1 under parallel projection
  float maxLevel;
  float sizeX;        // texels of the finest level
  float sizeY;
  float sharpLevel;  // whose texels are pixels of the screen or larger
  MIRROR_PICTURE picture;
};
