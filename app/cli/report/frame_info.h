// `info --frame`: one frame of a scene is drawn, and what that took is told. Needs a display.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/cli/options/render_options.h"
#include "app/cli/report/frame_costs.h"
#include "app/session/load_scene.h"
#include "filters/vtk/frame/frame_report.h"

namespace boxprobe {

/// Captures what the view of `camera` needs, draws it and reports. An automatic exposure becomes the scene's. `costs`:
/// where the time of that frame goes is measured, too.
FrameReport drawnFrameReport(LoadedScene& loaded, const std::string& scenePath, const std::string& camera,
                             FrameSize frame, const ReportOptions& options, FrameCosts* costs = nullptr);

nlohmann::ordered_json frameReportJson(const FrameReport& report);
std::string frameReportText(const FrameReport& report);

}  // namespace boxprobe
