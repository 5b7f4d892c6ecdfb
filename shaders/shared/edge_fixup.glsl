// CubeMapGen's edge fix-up: texels near an edge of a face are pulled towards the mean of the two texels that meet at the
// edge, which become equal. It was made for hardware that stops interpolating at a face's border: equal texels on both
// sides hide the jump there. Seamless lookups, as this program's, interpolate across the border and have no jump to hide;
// on them the fix-up does one thing only, it flattens the picture a little along the edges. It is kept as part of the
// frosty look's recipe and for files that go to readers without seamless lookups. Beside a small lamp it can take more than
// there is; what is left is then 0. Needs shared/cube.glsl.

// 1 at the edge, falling to 0 `width` texels inside.
float edgeFixupShare(float texelsFromEdge, float width)
{
  return width > 0.0f ? clamp(1.0f - texelsFromEdge / width, 0.0f, 1.0f) : 0.0f;
}

// How much of the difference (texel across the edge - texel on this side of it) is added: half makes the two equal. Of two
// edges the nearer counts; on the diagonal both do by a third, which makes the three texels at a corner of the cube equal.
// `other`: the share towards the other edge.
float edgeFixupPull(float share, float other)
{
  return share > other ? 0.5f * share : (share == other ? share / 3.0f : 0.0f);
}

// Direction to the edge texel across the edge s = side (-1 or 1) of a face of `faceSize`², beside t: the plane of the face
// folded over the edge of the cube. With alongT the edge is t = side, beside s.
vec3 directionAcrossEdge(int face, float side, float along, bool alongT, float faceSize)
{
  vec3 edge = alongT ? cubeDirection(face, along, side) : cubeDirection(face, side, along);
  return edge - cubeDirection(face, 0.0f, 0.0f) / faceSize;
}
