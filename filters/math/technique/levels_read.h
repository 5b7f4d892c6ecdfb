// Which levels of a probe's chain its lookups can reach, so that no other need be filtered. Called by who fills the
// maps; knows no map.
#pragma once

#include <cstdint>

#include "filters/math/technique/technique_table.h"

namespace boxprobe {

/// A bit for each level, that of level 0 the lowest.
using LevelMask = std::uint32_t;
constexpr LevelMask kAllLevels = ~LevelMask{0};

/// The whole levels that lookups between two levels mix, `low` <= `high`; both are brought into the chain.
LevelMask levelsBetween(float low, float high, int levels);

/// What `technique` looks up in a chain of `levels` for surfaces whose roughness lies in [`low`, `high`].
LevelMask levelsRead(const Technique& technique, const shading::TechniqueParameters& parameters, double low,
                     double high, int levels);

/// What is looked up in the sky's chain, which no technique reads: the levels of the roughness itself.
LevelMask skyLevelsRead(double low, double high, int levels);

}  // namespace boxprobe
