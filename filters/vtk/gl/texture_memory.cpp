#include "filters/vtk/gl/texture_memory.h"

#include <cstdlib>
#include <limits>

#include "filters/platform/process.h"
#include "filters/vtk/gl/opengl.h"
#include "filters/vtk/gl/software_driver.h"

namespace boxprobe {

namespace {

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

/// The result of a query in kilobytes; 0 if the driver does not support it.
std::size_t queried(GLenum name, bool supported) {
  if (!supported) return 0;
  GLint kilobytes[4] = {0, 0, 0, 0};
  glGetIntegerv(name, kilobytes);
  return kilobytes[0] > 0 ? static_cast<std::size_t>(kilobytes[0]) * 1024 : 0;
}

}  // namespace

std::size_t textureMemoryLimit() {
  if (const char* text = std::getenv("BOXPROBE_TEXTURE_MEMORY")) {
    char* end = nullptr;
    const double megabytes = std::strtod(text, &end);
    if (end != text && *end == '\0' && megabytes > 0.0 && megabytes < 1e12) {
      return static_cast<std::size_t>(megabytes * static_cast<double>(kMegabyte));
    }
  }
  // Textures of a software renderer are in main memory; Mesa 25's llvmpipe reports tens of megabytes.
  const bool card = !drawsOnCpu();
  if (const std::size_t all =
          queried(GL_GPU_MEMORY_INFO_TOTAL_AVAILABLE_MEMORY_NVX, card && BOXPROBE_HAS_MEMORY_INFO_NVX)) {
    return all;
  }
  if (const std::size_t left = queried(GL_TEXTURE_FREE_MEMORY_ATI, card && BOXPROBE_HAS_MEMORY_INFO_ATI)) return left;
  const std::uint64_t memory = physicalMemoryBytes();
  return memory > 0 ? static_cast<std::size_t>(memory / 2) : std::numeric_limits<std::size_t>::max();
}

}  // namespace boxprobe
