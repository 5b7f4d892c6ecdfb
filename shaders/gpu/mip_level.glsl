// A mip level of a texture: each texel is the mean of the four (or, for odd sizes, the nearest) of the level above, by
// the texture unit's own filter.
uniform sampler2D bpLevelAbove;

in vec2 texCoord;
out vec4 bpTexel;

void main()
{
  bpTexel = texture(bpLevelAbove, texCoord);
}
