// The precision of values in an OpenEXR file.
#pragma once

namespace boxprobe {

/// Half: 11 significant bits up to 65504, as on the GPU; larger values are clamped. Float: 24 bits.
enum class ExrPrecision { Half, Float };

}  // namespace boxprobe
