// Warnings about what a scene renderer shows, one sentence each.
#pragma once

#include <string>
#include <vector>

#include "filters/core/base/counters.h"
#include "filters/vtk/frame/frame_report.h"

namespace boxprobe {

struct SceneContent;

/// In addition to those about the probes' pictures: the sky's image, glass inside itself, omitted probes (`report`),
/// and corrected light of captures (`counters`).
std::vector<std::string> sceneRemarks(const SceneContent& content, const FrameReport& report, const Counters& counters);

}  // namespace boxprobe
