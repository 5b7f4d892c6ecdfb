// Two axes perpendicular to the middle of a lobe, in which the directions of its samples are given. Unlike the usual
// frame with a switch of sign, which turns the pattern abruptly along the great circle z = 0 and leaves a line there
// wherever the samples are too few, this one turns continuously everywhere but at the single point -Z.

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
