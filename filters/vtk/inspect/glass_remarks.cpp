#include "filters/vtk/inspect/glass_remarks.h"

#include <algorithm>
#include <set>
#include <utility>

#include "filters/vtk/scene/scene_content.h"

namespace boxprobe {

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

}  // namespace boxprobe
