// What several processes, on one machine or many, make of a scene's baked probes: who makes which, and about how long
// it takes. The same in each of them, without a word between them. Knows neither files nor OpenGL.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// Share `index` of `count`, from 1.
struct BakeShare {
  int index = 1, count = 1;
};

/// "3/8", or "auto": the place in Slurm's array job, among mpiexec's processes or among srun's, by their environment.
/// Throws InputError naming --shard.
BakeShare parseBakeShare(const std::string& text);

/// The place among the processes that mpiexec started (Open MPI, MPICH and what follows them); nothing outside of it.
std::optional<BakeShare> mpiShare();

/// CPU seconds that a probe's capture and filter take, all bounces, as `boxprobe bake --stats` measured them with
/// llvmpipe in the scene `building`, faces of 32 to 512 texels. Elsewhere their ratios hold better than they do.
double bakeSeconds(const Probe& probe);
/// Bytes of its file, measured likewise: colours and distances compress by about a third.
double bakeBytes(const Probe& probe);

/// The names of `probes` that are this share: the longest is given away first, each to the share with the least to do,
/// so that all end at about the same time. In the order of the scene.
std::vector<std::string> probesOfShare(const std::vector<Probe>& probes, const BakeShare& share);

}  // namespace boxprobe
