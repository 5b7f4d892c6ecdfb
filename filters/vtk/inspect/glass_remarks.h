// What is odd about a scene's glass, one sentence each, for warnings. Called by the scene renderer.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

struct SceneContent;

/// Probes that see the very object they are looked through: it would show within itself.
std::vector<std::string> glassRemarks(const SceneContent& content);

}  // namespace boxprobe
