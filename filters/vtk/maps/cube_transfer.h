// A probe's maps between the graphics side and plain values, exactly: half floats become floats and the same half
// floats again. Called by the scene renderer for previews and explanations, and by the bake cache for files. Every
// function needs the window's context current. Knows neither scenes nor files.
#pragma once

#include <memory>

#include "filters/core/picture/baked_probe.h"
#include "filters/io/cube/sky_levels.h"
#include "filters/vtk/maps/probe_maps.h"

namespace boxprobe {

/// Everything a probe holds; levels that nothing sampled so far are filtered. Waits until the graphics side has
/// finished what is under way.
BakedMaps readBack(const ProbeMaps& maps);

/// The same without filtering: a level that nothing sampled so far holds plain means of the capture.
BakedMaps readBackAsShown(const ProbeMaps& maps);

/// Of readBack(), the chain alone.
CubeMap readRadiance(const ProbeMaps& maps);

/// Its level 0 alone into level 0 of `cube`, of the same face size.
void readLevel0(const CubeTexture& texture, CubeMap& cube);

/// The other way. Maps without distances stay without. `forTheTimeBeing`: see ProbeMaps.
std::shared_ptr<const ProbeMaps> upload(const BakedMaps& maps, bool forTheTimeBeing = false);

/// Of a sky.
std::shared_ptr<const ProbeMaps> upload(const SkyLevels& levels);

/// Level 0 of `cube` into level 0 of `texture`, allocated at the same face size.
void uploadLevel0(const CubeMap& cube, CubeTexture& texture);

}  // namespace boxprobe
