// CubeMapGen's edge fix-up: pulls texels near an edge of a face towards the mean of the two texels that meet at the
// edge, which become equal. It was made for hardware that stops interpolating at a face's border, where equal texels
// hide the seam. Seamless lookups, as in this program, need no fix-up; with them it only flattens the picture a little
// along the edges. It is kept for the Gaussian filter of CubeMapGen, and for files whose readers lack seamless lookups.
// Beside a small lamp the result may be negative, and is then 0. Needs shared/cube.glsl.

// 1 at the edge, falling to 0 `width` texels inside.
float edgeFixupShare(float texelsFromEdge, float width)
{
  return width > 0.0f ? clamp(1.0f - texelsFromEdge / width, 0.0f, 1.0f) : 0.0f;
}

// The fraction of the difference (texel across the edge - texel on this side) to add: one half makes them equal. Of two
// edges the nearer counts; on the diagonal both count by a third, which makes the three texels at a corner of the cube
// equal. `other`: the share towards the other edge.
float edgeFixupPull(float share, float other)
{
  return share > other ? 0.5f * share : (share == other ? share / 3.0f : 0.0f);
}

// Direction to the edge texel across the edge s = side (-1 or 1) of a face of `faceSize`², at the same t: the plane of
// the face folded over the edge of the cube. With alongT the edge is t = side, at the same s.
vec3 directionAcrossEdge(int face, float side, float along, bool alongT, float faceSize)
{
  vec3 edge = alongT ? cubeDirection(face, along, side) : cubeDirection(face, side, along);
  return edge - cubeDirection(face, 0.0f, 0.0f) / faceSize;
}
