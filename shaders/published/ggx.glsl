// For comparison and teaching only: GGX as it is printed (Walter 2007, Karis 2013).

// NH² (alpha² - 1) + 1 subtracts two numbers near 1 wherever alpha is small.
float publishedDistribution(float nh, float alpha)
{
  float a2 = alpha * alpha;
  float q = nh * nh * (a2 - 1.0f) + 1.0f;
  return a2 / (3.14159265f * q * q);
}

// 0 / 0 for a mirror seen edge-on.
float publishedMasking(float nv, float alpha)
{
  float a2 = alpha * alpha;
  return 2.0f * nv / (nv + sqrt(a2 + (1.0f - a2) * nv * nv));
}
