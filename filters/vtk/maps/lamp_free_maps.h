// A probe's chain in which lamps that are drawn as shapes do not show: what rough surfaces look up. Alpha, which is
// coverage in the probe's own chain, holds the lamps' light, the mean of its colours, so that one lookup gives both.
// Called by the probe pass, with the window's context current; knows no scene.
#pragma once

#include <functional>
#include <vector>

#include "filters/vtk/maps/probe_maps.h"

namespace boxprobe {

/// Filters the levels of a mask from a chain's level 0.
using ChainFilter = std::function<void(const CubeTexture& chain, LevelMask levels)>;

/// Makes `maps.lampFree` without `lamps` (relative to the capture origin, along the map's axes), unless it is there,
/// and those of `levels` that are missing. Made again for other lamps, but not while a box is `dragged`. False: there
/// is no memory for it, which is not tried again.
bool makeLampFreeMaps(const ProbeMaps& maps, const std::vector<LampPolygon>& lamps, LevelMask levels, bool dragged,
                      const ChainFilter& filter);

}  // namespace boxprobe
