// Which mip levels lookups of a probe can reach, so that no other needs filtering.
#pragma once

#include <cstdint>

#include "filters/math/technique/technique_table.h"

namespace boxprobe {

/// One bit per level, level 0 the lowest.
using LevelMask = std::uint32_t;
constexpr LevelMask kAllLevels = ~LevelMask{0};

/// The integer levels between which lookups interpolate, `low` <= `high`, both clamped to the chain.
LevelMask levelsBetween(float low, float high, int levels);

/// The levels that `technique` samples in a chain of `levels` for surfaces whose roughness lies in [`low`, `high`].
LevelMask levelsRead(const Technique& technique, const shading::TechniqueParameters& parameters, double low,
                     double high, int levels);

/// The levels sampled in the sky's chain, which techniques do not read: those of the roughness itself.
LevelMask skyLevelsRead(double low, double high, int levels);

}  // namespace boxprobe
