// Pseudorandom numbers in integer arithmetic, bit-identical on GPU and CPU.

// PCG's output permutation (O'Neill 2014) over one step of its generator; Jarzynski and Olano 2020 measured it for shaders.
uint hashed(uint value)
{
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

uint pixelHash(ivec2 pixel)
{
  return hashed(uint(pixel.x) + hashed(uint(pixel.y)));
}

// In [0, 1): the upper 24 bits, which a float holds exactly.
float unitNumber(uint bits)
{
  return float(bits >> 8u) * 5.9604644775390625e-8f;
}
