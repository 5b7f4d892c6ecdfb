// Copies a probe's maps between GPU and CPU exactly: half floats are converted to floats and back without loss. Every
// function needs the window's context current.
#pragma once

#include <memory>

#include "filters/core/picture/baked_probe.h"
#include "filters/io/cube/sky_levels.h"
#include "filters/vtk/maps/probe_maps.h"

namespace boxprobe {

/// All contents of a probe; filters missing levels first. Waits for the GPU.
BakedMaps readBack(const ProbeMaps& maps);

/// The same without filtering: missing levels hold plain means of the capture.
BakedMaps readBackAsShown(const ProbeMaps& maps);

/// Only the chain of readBack().
CubeMap readRadiance(const ProbeMaps& maps);

/// Reads only level 0, into level 0 of `cube`, of the same face size.
void readLevel0(const CubeTexture& texture, CubeMap& cube);

/// The opposite direction. Maps without distances stay without. `forTheTimeBeing`: see ProbeMaps.
std::shared_ptr<const ProbeMaps> upload(const BakedMaps& maps, bool forTheTimeBeing = false);

/// Uploads a sky's levels.
std::shared_ptr<const ProbeMaps> upload(const SkyLevels& levels);

/// Level 0 of `cube` into level 0 of `texture`, allocated with the same face size.
void uploadLevel0(const CubeMap& cube, CubeTexture& texture);

}  // namespace boxprobe
