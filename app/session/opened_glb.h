// A .glb that holds a scene with its probes (filters/io/engines/glb_probes.h) is opened by unpacking it into the user's
// cache, once for each content; from there baked files and pictures are read like those beside a scene.
#pragma once

#include <string>

#include "filters/core/scene/scene.h"

namespace boxprobe {

/// The scene of a .glb with probes, its pictures and maps unpacked. Throws InputError, WorkError.
Scene openGlbScene(const std::string& path);

/// The folder of the baked probes of what is opened from `path`: for a .glb with probes those in it, else the folder
/// beside it. Throws as above.
std::string bakedFolderOf(const std::string& path);

/// What an opened scene goes by: its own file, else its first model's. Empty without either.
std::string ownPathOf(const std::string& scenePath, const Scene& scene);

}  // namespace boxprobe
