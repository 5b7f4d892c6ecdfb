// The studio environment, computed.
#pragma once

#include <string>

namespace boxprobe::environments {

/// Bytes of a Radiance HDR file: latitude-longitude, linear radiance, the same on every run.
std::string studioHdr();

}  // namespace boxprobe::environments
