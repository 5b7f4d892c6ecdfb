#include "filters/vtk/frame/frame_report.h"

#include <algorithm>

namespace boxprobe {

namespace {

std::string counted(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

template <typename Which>
std::size_t drawnObjects(const FrameReport& report, Which which) {
  return static_cast<std::size_t>(
      std::count_if(report.objects.begin(), report.objects.end(),
                    [&](const FrameReport::Object& object) { return object.drawn && which(object); }));
}

}  // namespace

std::vector<std::string> skippedLines(const FrameReport& report) {
  using Object = FrameReport::Object;
  std::vector<std::string> lines;
  const auto say = [&](std::size_t n, const char* one, const char* many, const std::string& rest) {
    if (n > 0) lines.push_back(counted(n, one, many) + rest);
  };
  const std::size_t drawn = drawnObjects(report, [](const Object&) { return true; });
  say(report.objects.size() - drawn, "object is", "objects are", " out of view or hidden: not drawn");
  if (report.skyCulled) lines.push_back("the sky behind everything shows nowhere: not drawn");
  const auto without = [&](bool used) {
    return static_cast<std::size_t>(std::count_if(
        report.probes.begin(), report.probes.end(),
        [&](const FrameReport::ProbeUse& probe) { return (probe.objects > 0) == used && probe.drawn == 0; }));
  };
  say(without(false), "probe lights", "probes light", " no visible object: nothing is captured for it");
  say(without(true), "probe lights", "probes light", " only what this frame does not show");
  const auto notMade = std::count_if(report.probes.begin(), report.probes.end(),
                                     [](const FrameReport::ProbeUse& probe) { return probe.bytes == 0; });
  say(static_cast<std::size_t>(notMade), "probe holds", "probes hold", " no texture");
  std::size_t levels = 0, notFiltered = 0;
  for (const FrameReport::ProbeUse& probe : report.probes) {
    levels += probe.levels;
    notFiltered += probe.notFiltered;
  }
  say(notFiltered, "mip level", "mip levels",
      " of " + std::to_string(levels) + " not filtered: no material samples " + (notFiltered == 1 ? "it" : "them"));
  say(drawnObjects(report, [](const Object& o) { return o.unlit; }), "draw is", "draws are",
      " unlit: no light, no probe");
  say(drawnObjects(report, [](const Object& o) { return !o.unlit && o.probes.empty(); }), "draw has", "draws have",
      " no probe: only the sky, no projection");
  say(drawnObjects(report, [](const Object& o) { return o.probes.size() == 1 && !o.weights; }), "draw has",
      "draws have", " one probe at full weight: no weights computed, no second lookup");
  say(drawnObjects(report, [](const Object& o) { return !o.probes.empty() && o.sky <= 0.0; }), "draw leaves",
      "draws leave", " nothing to the sky: the sky is not sampled");
  for (const FrameReport::MirrorUse& mirror : report.mirrors) {
    if (!mirror.drawn) lines.push_back("mirror \"" + mirror.node + "\" has no picture: " + mirror.why);
  }
  return lines;
}

std::vector<std::string> mirrorLines(const FrameReport& report) {
  std::vector<std::string> lines;
  for (const FrameReport::MirrorUse& mirror : report.mirrors) {
    if (!mirror.drawn) continue;
    lines.push_back("\"" + mirror.node + "\": " + std::to_string(mirror.width) + " x " + std::to_string(mirror.height) +
                    " texels, " + counted(mirror.objects, "object that moves", "objects that move") + ", " +
                    counted(mirror.hiding, "object that may hide them", "objects that may hide them") +
                    " in depth alone");
  }
  return lines;
}

std::vector<std::string> leftOutLines(const FrameReport& report) {
  std::vector<std::string> lines;
  for (const FrameReport::Object& object : report.objects) {
    if (object.leftOut > 0) {
      lines.push_back(
          "objects." + object.node + ": " + counted(object.leftOut, "probe", "probes") + " beyond the " +
          std::to_string(object.probes.size()) +
          " most important ones reach it and are left out; divide the object, or raise importance where it counts");
    }
    if (!object.givenUp.empty()) {
      lines.push_back("objects." + object.node +
                      ": this OpenGL driver has too few texture units for its probes and textures; " + object.givenUp);
    }
  }
  return lines;
}

}  // namespace boxprobe
