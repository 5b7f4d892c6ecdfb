// Collects a FrameReport about the last frame.
#pragma once

#include "filters/vtk/frame/frame_report.h"
#include "filters/vtk/frame/mirror_set.h"
#include "filters/vtk/probes/probe_set.h"

namespace boxprobe {

FrameReport reportFrame(const SceneContent& content, const ProbeSet& probes, const MirrorSet& mirrors,
                        const Counters& counters);
/// Programs, in the order of their first object.
std::vector<DrawnProgram> drawnPrograms(const SceneContent& content);
/// From a picture drawn with the debug view of lookups, transparent where there is no surface.
FrameReport::Lookups lookupsOf(const ImageRgbaF& picture);

}  // namespace boxprobe
