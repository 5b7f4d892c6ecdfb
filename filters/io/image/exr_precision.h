// How many bits a value of an OpenEXR file has.
#pragma once

namespace boxprobe {

/// Half: 11 significant bits up to 65504, what the GPU holds; larger values are brought down to that. Float: 24 bits.
enum class ExrPrecision { Half, Float };

}  // namespace boxprobe
