// WebP pictures through libwebp.
#pragma once

#include <cstddef>
#include <string>

#include "filters/core/scene/model.h"

namespace boxprobe {

bool isWebp(const unsigned char* bytes, std::size_t size);

/// As decodeImage8. Animated files are refused.
ImageRgba8 decodeWebp(const unsigned char* bytes, std::size_t size, const std::string& name, bool* hasAlpha);

}  // namespace boxprobe
