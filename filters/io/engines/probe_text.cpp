#include "filters/io/engines/probe_text.h"

#include <nlohmann/json.hpp>

#include "filters/core/base/errors.h"
#include "filters/io/scene/scene_file.h"

namespace boxprobe {

std::string probeLine(const Probe& probe) {
  Scene scene;
  scene.probes = {probe};
  return nlohmann::ordered_json::parse(sceneText(scene, ""))["probes"][0].dump();
}

Probe probeOfLine(const std::string& line, const std::string& name) {
  const Scene scene = parseScene(R"({"format": "boxprobe-scene", "version": 1, "probes": [)" + line + "]}", name, "");
  if (scene.probes.size() != 1) throw InputError(name + ": holds no probe");
  return scene.probes.front();
}

}  // namespace boxprobe
