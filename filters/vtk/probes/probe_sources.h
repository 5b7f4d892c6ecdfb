// Where maps come from besides captures: those that were made before, the folder of baked files, pictures of the
// user's, the levels that come with a sky's picture. Shared by the plan, which asks what there is, and the work, which takes it. Neither OpenGL nor VTK: maps are
// known by key.
#pragma once

#include <functional>
#include <string>

#include "filters/io/cube/bake_folder.h"
#include "filters/io/cube/sky_levels.h"
#include "filters/vtk/probes/custom_pictures.h"

namespace boxprobe {

struct ProbeSources {
  std::function<bool(const std::string& key)> cached;  ///< are the maps of that key at hand?
  BakeFolder folder;
  CustomPictures pictures;
  std::string skyLevels;  ///< the file beside the sky's picture; empty: the sky is no picture, or the file is damaged

  /// May a job take them instead of making them?
  bool have(const std::string& key) const { return cached(key) || folder.has(key); }
};

}  // namespace boxprobe
