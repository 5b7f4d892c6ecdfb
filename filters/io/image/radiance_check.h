// Whether the runs of a Radiance HDR picture make up its rows, before a decoder follows them that would wait for ever
// for a run that never comes. Called by image_file; knows nothing of what the pixels are.
#pragma once

#include <string>

namespace boxprobe {

/// `bytes`: the whole file; width as its header has it. Rows that are not in runs are left to the decoder.
bool radianceRunsAreWhole(const std::string& bytes, int width, int height);

}  // namespace boxprobe
