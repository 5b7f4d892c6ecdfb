// Baked files of several folders brought together into one, and what the way there left behind taken away.
#pragma once

#include <string>
#include <vector>

#include "app/cli/farm/bake_listing.h"

namespace boxprobe {

/// Throws InputError unless all files of `rows` that `folder` has have `maker`, naming one that has not. Renderers
/// round differently: a bake of two is the same twice only by chance.
void requireMaker(const std::vector<BakeRow>& rows, const BakeFolder& folder, const BakeMaker& maker);

struct BakeMerge {
  std::vector<std::string> written;  ///< files, in the folder
  int removed = 0;                   ///< files of earlier bounces, which nobody needs once all is done
};

/// Copies to `folder` what `rows` miss and one of `sources` has; each file is looked at whole and written whole. Brings
/// `rows` up to date. Throws InputError, before anything is written, for a source that is no folder, a file that shows
/// another state of the scene, and unless `mixed` for files of different programs or renderers.
BakeMerge mergeBaked(std::vector<BakeRow>& rows, const std::string& folder, const std::vector<std::string>& sources,
                     bool mixed);

}  // namespace boxprobe
