// What a level of a prefiltered chain is filtered with: the kernel around a texel's direction, and the sample
// directions and weights that integrate it. One source for both prefilters and the reference that judges them.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace boxprobe {

/// A kernel that depends only on the angle to its middle.
struct FilterLobe {
  enum class Kind { Ggx, Gaussian };
  Kind kind = Kind::Ggx;
  /// GGX: alpha = perceptual roughness². Gaussian: standard deviation, radians.
  float width = 0.0f;
};

/// Parameters of CubeMapGen's angular Gaussian, with its meanings: an angle is that of the whole cone that a filter
/// covers, which holds three standard deviations to either side. Level 0 is filtered by the base angle, and each
/// further level by its own angle on top of the level before; variances add up.
struct GaussianSettings {
  float baseAngleDegrees = 8.0f;        ///< level 0; 0 leaves the capture as it is
  float initialMipAngleDegrees = 5.0f;  ///< angle of level 1
  float mipAngleScale = 2.0f;           ///< ratio of the angles of successive levels
  /// Texels over which the two sides of a face's edge are blended until they are equal (edge_fixup.glsl). 4 in
  /// CubeMapGen; 0 here, because seamless lookups need no fixup and a lamp near an edge would get a dark patch beside
  /// it.
  int edgeFixupWidth = 0;
};

/// How a chain is made from a capture.
struct PrefilterSettings {
  FilterLobe::Kind filter = FilterLobe::Kind::Ggx;
  /// Samples per texel of level 1; each further level has half the texels per side and takes twice as many, up to
  /// kMaxSamples. Quality against time: tests/bench/README.md, "Prefilter".
  int samples = 64;
  GaussianSettings gaussian;
};

constexpr int kMinSamples = 8;
/// Capacity of shaders/gpu/prefilter_lobe.glsl.
constexpr int kMaxSamples = 768;

/// Number of levels for a face size: the last one has 4 x 4 texels, enough for the lobe of roughness 1.
int prefilterLevels(int faceSize);
/// The kernel of a level. Width 0: the level is a copy of the source.
FilterLobe lobeOfLevel(const PrefilterSettings& settings, int level, int maxLevel);
int samplesOfLevel(const PrefilterSettings& settings, int level);

/// The kernel, not normalised, from 1 - cos of the angle, which keeps the digits that the cosine loses near 0. 0 beyond
/// the horizon. GGX: D(h) cos(angle) for N = V = R, so that angle = 2 angle(h) (split sum, Karis 2013).
float lobeKernel(const FilterLobe& lobe, float oneMinusCosine);

/// One sample of the quadrature.
struct LobeTap {
  glm::vec3 direction;  ///< in the frame of the lobe: z is its axis, x and y are those of shared/lobe_frame.glsl
  float level;          ///< of the source's mip chain, for a texel of mean solid angle
  float weight;         ///< the weights of a lobe sum to 1
};

/// The samples that integrate a lobe over a cubemap. Their directions lie on a Fibonacci spiral, so they are even in
/// azimuth and solid angle for any count. Each reads a mip level whose texels cover its share of solid angle (filtered
/// importance sampling, Krivanek and Colbert 2008). The weights are such that samples and footprints together add up to
/// the lobe.
std::vector<LobeTap> lobeTaps(const FilterLobe& lobe, int count, int sourceFaceSize);

}  // namespace boxprobe
