// What is odd about what a scene renderer shows, one sentence each, for warnings. Called by the scene renderer.
#pragma once

#include <string>
#include <vector>

#include "filters/core/base/counters.h"
#include "filters/vtk/frame/frame_report.h"

namespace boxprobe {

struct SceneContent;

/// After the remarks on the probes' pictures: the sky's image, glass within itself, probes left out (`report`), and
/// captured light that was put right (`counters`).
std::vector<std::string> sceneRemarks(const SceneContent& content, const FrameReport& report, const Counters& counters);

}  // namespace boxprobe
