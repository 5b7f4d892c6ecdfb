// Where in the unit square the samples of a pixel lie, frame after frame, by one of the patterns of parameter `pattern`:
//   0 white          nothing but chance: clumps and gaps, noise of every frequency
//   1 blue           a spiral of golden angles, as even as a disk can be filled, turned and shifted by a blue-noise mask: unlike those of the
//                    pixels around, so that what noise is left is fine-grained and the eye or a small blur averages it out
//   2 r2             evenly spread, shifted by a hash of the pixel
//   3 deterministic  the same in every pixel: no noise, but ghost copies of small lamps where the samples are too few
//   4 refined        as r2, shifted by the blue-noise mask: of pictures that go on until all rays are there; no scene asks for it
// x becomes the angle about the lobe's middle, y the area around it (visible_normal.glsl). Both are 32-bit fractions, so that adding
// wraps around by itself and nothing is lost after many frames. Frames continue the sequence, or shift by it: 64 frames of one
// sample fill the lobe as 64 samples of one frame do. Needs shared/hash.glsl; the host supplies fetchBlueNoise.

// The R2 sequence (Roberts 2018): multiples of the inverse powers 2 and 1 of the plastic number, as fractions of 2^32.
const uint kR2X = 2447445413u;
const uint kR2Y = 3242174889u;
// The golden ratio's, which turns a spiral's points such that none hides behind another.
const uint kGolden = 2654435769u;

// `samples` of a frame.
SamplePattern samplePattern(ShadingPoint point, int pattern, int samples)
{
  uint count = uint(max(samples, 1));
  SamplePattern result;
  result.pattern = pattern;
  result.first = uint(point.frame) * count;
  result.step = 0xffffffffu / count;
  result.shiftX = uint(point.frame) * kR2X;
  result.shiftY = uint(point.frame) * kR2Y;
  if (pattern == 0) { result.shiftX = pixelHash(point.pixel); }
  if (pattern == 1)
  {
    vec2 mask = fetchBlueNoise(point.pixel);
    result.shiftX = result.shiftX + (uint(mask.x * 16777216.0f) << 8u);
    result.shiftY = (result.shiftY + (uint(mask.y * 16777216.0f) << 8u)) / count;
  }
  if (pattern == 4)
  {
    vec2 mask = fetchBlueNoise(point.pixel);
    result.shiftX = uint(mask.x * 16777216.0f) << 8u;
    result.shiftY = uint(mask.y * 16777216.0f) << 8u;
  }
  if (pattern == 2)
  {
    result.shiftX = pixelHash(point.pixel);
    result.shiftY = hashed(result.shiftX);
  }
  return result;
}

// Sample `i` of those of this frame, in [0, 1)².
vec2 samplePoint(SamplePattern pattern, int i)
{
  uint index = uint(i);
  if (pattern.pattern == 0)
  {
    uint x = hashed(pattern.shiftX + pattern.first + index);
    return vec2(unitNumber(x), unitNumber(hashed(x)));
  }
  if (pattern.pattern == 3)  // Hammersley: evenly along one axis, the bits of the number reversed along the other
  {
    uint y = index;
    y = ((y & 0x55555555u) << 1u) | ((y >> 1u) & 0x55555555u);
    y = ((y & 0x33333333u) << 2u) | ((y >> 2u) & 0x33333333u);
    y = ((y & 0x0f0f0f0fu) << 4u) | ((y >> 4u) & 0x0f0f0f0fu);
    y = y << 24u;  // numbers below 256: their eight bits are all there is
    return vec2(unitNumber(pattern.shiftX + index * pattern.step + (pattern.step >> 1u)), unitNumber(pattern.shiftY + y));
  }
  if (pattern.pattern == 1)
  {
    return vec2(unitNumber(pattern.shiftX + index * kGolden), unitNumber(pattern.shiftY + index * pattern.step));
  }
  index = pattern.first + index;
  return vec2(unitNumber(pattern.shiftX + index * kR2X), unitNumber(pattern.shiftY + index * kR2Y));
}
