#include "filters/vtk/inspect/render_remarks.h"

#include <algorithm>
#include <set>
#include <utility>

#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

namespace {

// Probes that see the very object they are seen through, which would show inside itself.
std::vector<std::string> glassRemarks(const SceneContent& content) {
  std::vector<std::string> texts;
  std::set<std::pair<int, std::string>> said;  // a node may be drawn in pieces
  for (const DrawnObject& object : content.objects) {
    if (!object.settings.visible || !object.settings.seenByProbes || !object.pass->DrawsGlass()) continue;
    for (const auto& drawn : object.pass->GetBinding()->probes) {
      const Probe& probe = content.scene.probes[static_cast<std::size_t>(drawn->index)];
      const bool custom = probe.mode == ProbeMode::Custom;
      const bool left = object.settings.dynamic && probe.mode != ProbeMode::Realtime;
      const bool hidden = std::find(probe.hides.begin(), probe.hides.end(), object.node) != probe.hides.end();
      if (custom || left || hidden || !said.insert({drawn->index, object.node}).second) continue;
      texts.push_back("probes." + probe.name + ".hides: the probe sees \"" + object.node +
                      "\", which transmits light and is looked through with it, so it shows within itself; add it to "
                      "hides");
    }
  }
  return texts;
}

}  // namespace

std::vector<std::string> sceneRemarks(const SceneContent& content, const FrameReport& report,
                                      const Counters& counters) {
  std::vector<std::string> texts;
  const auto* image = std::get_if<SkyImage>(&content.scene.sky);
  if (image != nullptr) {
    for (const std::string& sentence : content.skyNotes.repairs.sentences()) {
      texts.push_back("sky.image: " + image->file + ": " + sentence);
    }
  }
  constexpr std::size_t kNamed = 5;
  const auto addFirst = [&](const std::vector<std::string>& lines) {
    texts.insert(texts.end(), lines.begin(), lines.begin() + static_cast<long>(std::min(lines.size(), kNamed)));
  };
  addFirst(glassRemarks(content));
  const std::vector<std::string> leftOut = english(leftOutLines(report));
  addFirst(leftOut);
  if (leftOut.size() > kNamed) {
    texts.push_back("and " + std::to_string(leftOut.size() - kNamed) +
                    " more lines of this kind; `info --frame` has all");
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
