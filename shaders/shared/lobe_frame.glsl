// Two axes perpendicular to the axis of a lobe, for the directions of its samples. The usual frame, with a switch of
// sign, rotates the pattern abruptly at the great circle z = 0 and shows a line there if samples are few; this one is
// continuous everywhere except at the point -Z.

// Both axes share 1 / (1 + n.z). Written without the sum, which cancels towards -Z: (1 + z)(1 - z) = x² + y².
float lobeFrameScale(vec3 n)
{
  return n.z > 0.0f ? 1.0f / (1.0f + n.z) : (1.0f - n.z) / max(n.x * n.x + n.y * n.y, 1.0e-30f);
}

vec3 lobeTangent(vec3 n)
{
  float a = lobeFrameScale(n);
  return vec3(1.0f - n.x * n.x * a, -n.x * n.y * a, -n.x);
}

vec3 lobeBitangent(vec3 n)
{
  float a = lobeFrameScale(n);
  return vec3(-n.x * n.y * a, 1.0f - n.y * n.y * a, -n.y);
}
