// `fetchBlueNoise` on the GPU. BP_BLUE_NOISE: a technique of the draw uses the mask.
#if BP_BLUE_NOISE
uniform sampler2D bpBlueNoise;  // 64 x 64, repeated
vec2 fetchBlueNoise(ivec2 pixel) { return texelFetch(bpBlueNoise, pixel & ivec2(63), 0).rg; }
#else
vec2 fetchBlueNoise(ivec2 pixel) { return vec2(0.0f); }
#endif
