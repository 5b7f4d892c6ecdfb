// Checks the runs of a Radiance HDR picture before decoding, because the decoder would loop forever on an incomplete
// row.
#pragma once

#include <string>

namespace boxprobe {

/// `bytes`: the whole file; `width`: from its header. Rows without runs are left to the decoder.
bool radianceRunsAreWhole(const std::string& bytes, int width, int height);

}  // namespace boxprobe
