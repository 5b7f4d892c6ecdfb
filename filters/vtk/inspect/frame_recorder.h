// Collects what the last frame was drawn with into a FrameReport. Called by the scene renderer, when somebody asks.
#pragma once

#include "filters/vtk/frame/frame_report.h"
#include "filters/vtk/frame/mirror_set.h"
#include "filters/vtk/probes/probe_set.h"

namespace boxprobe {

FrameReport reportFrame(const SceneContent& content, const ProbeSet& probes, const MirrorSet& mirrors,
                        const Counters& counters);
/// Programs by their first object.
std::vector<DrawnProgram> drawnPrograms(const SceneContent& content);
/// Of a picture drawn with the debug view of lookups, transparent where no surface is.
FrameReport::Lookups lookupsOf(const ImageRgbaF& picture);

}  // namespace boxprobe
