#include "filters/vtk/gl/software_driver.h"

#include <algorithm>
#include <cstdlib>

#include "filters/vtk/gl/opengl.h"

namespace boxprobe {

std::string rendererName() {
  const char* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return text != nullptr ? text : "";
}

bool drawsOnCpu() {
  const std::string renderer = rendererName();
  // "Software": Apple's renderer and Mesa's oldest. "Basic Render": Microsoft's WARP.
  for (const char* software : {"llvmpipe", "softpipe", "SWR", "swrast", "Software", "Basic Render"}) {
    if (renderer.find(software) != std::string::npos) return true;
  }
  return false;
}

bool tunedForCpu() {
  const char* text = std::getenv("BOXPROBE_RENDERER_TUNING");
  const std::string asked = text != nullptr ? text : "";
  return asked == "cpu" || (asked != "gpu" && drawsOnCpu());
}

bool drawsLevelFromLevel() {
  const std::string renderer = rendererName();
  return renderer.find("softpipe") == std::string::npos && renderer.find("zink") == std::string::npos;
}

float textureAnisotropy() {
  if (const char* asked = std::getenv("BOXPROBE_ANISOTROPY")) {
    return static_cast<float>(std::clamp(std::atoi(asked), 1, 16));
  }
  constexpr float kOnCards = 8.0f, kNone = 1.0f;
  return rendererName().empty() || drawsOnCpu() ? kNone : kOnCards;
}

}  // namespace boxprobe
