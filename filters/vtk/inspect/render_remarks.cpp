#include "filters/vtk/inspect/render_remarks.h"

#include <algorithm>

#include "filters/vtk/inspect/glass_remarks.h"
#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

std::vector<std::string> sceneRemarks(const SceneContent& content, const FrameReport& report,
                                      const Counters& counters) {
  std::vector<std::string> texts;
  const auto* image = std::get_if<SkyImage>(&content.scene.sky);
  if (image != nullptr && content.skyTexelsNotFinite > 0) {
    texts.push_back("sky.image: " + image->file + ": " + std::to_string(content.skyTexelsNotFinite) +
                    " texels are NaN or infinite and were set to 0");
  }
  constexpr std::size_t kNamed = 5;
  const auto addFirst = [&](const std::vector<std::string>& lines) {
    texts.insert(texts.end(), lines.begin(), lines.begin() + static_cast<long>(std::min(lines.size(), kNamed)));
  };
  addFirst(glassRemarks(content));
  const std::vector<std::string> leftOut = leftOutLines(report);
  addFirst(leftOut);
  if (leftOut.size() > kNamed) {
    texts.push_back("and " + std::to_string(leftOut.size() - kNamed) + " more objects that more probes reach");
  }
  if (counters.texelsNotFinite > 0) {
    texts.push_back(std::to_string(counters.texelsNotFinite) +
                    " captured samples were NaN or infinite and were set to 0");
  }
  if (counters.texelsClamped > 0) {
    texts.push_back(
        std::to_string(counters.texelsClamped) +
        " captured samples were brighter than 65504, the most a half float holds, and were brought down to it");
  }
  return texts;
}

}  // namespace boxprobe
