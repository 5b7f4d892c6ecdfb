// Warnings about a scene's glass, one sentence each.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

struct SceneContent;

/// Probes that see the very object they are seen through, which would show inside itself.
std::vector<std::string> glassRemarks(const SceneContent& content);

}  // namespace boxprobe
