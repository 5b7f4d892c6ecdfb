#include "filters/vtk/frame/frame_report.h"

#include <algorithm>

namespace boxprobe {

namespace {

template <typename Which>
std::size_t drawnObjects(const FrameReport& report, Which which) {
  return static_cast<std::size_t>(
      std::count_if(report.objects.begin(), report.objects.end(),
                    [&](const FrameReport::Object& object) { return object.drawn && which(object); }));
}

}  // namespace

std::vector<Phrase> skippedLines(const FrameReport& report) {
  using Object = FrameReport::Object;
  std::vector<Phrase> lines;
  const auto say = [&](std::size_t n, const Phrase& one, const Phrase& many) {
    if (n > 0) lines.push_back((n == 1 ? one : many).arg(std::to_string(n)));
  };
  const std::size_t drawn = drawnObjects(report, [](const Object&) { return true; });
  say(report.objects.size() - drawn, Phrase::tr("%1 object is out of view or hidden: not drawn"),
      Phrase::tr("%1 objects are out of view or hidden: not drawn"));
  if (report.skyCulled) lines.push_back(Phrase::tr("the sky behind everything shows nowhere: not drawn"));
  const auto without = [&](bool used) {
    return static_cast<std::size_t>(std::count_if(
        report.probes.begin(), report.probes.end(),
        [&](const FrameReport::ProbeUse& probe) { return (probe.objects > 0) == used && probe.drawn == 0; }));
  };
  say(without(false), Phrase::tr("%1 probe lights no visible object: nothing is captured for it"),
      Phrase::tr("%1 probes light no visible object: nothing is captured for it"));
  say(without(true), Phrase::tr("%1 probe lights only what this frame does not show"),
      Phrase::tr("%1 probes light only what this frame does not show"));
  const auto notMade = std::count_if(report.probes.begin(), report.probes.end(),
                                     [](const FrameReport::ProbeUse& probe) { return probe.bytes == 0; });
  say(static_cast<std::size_t>(notMade), Phrase::tr("%1 probe holds no texture"),
      Phrase::tr("%1 probes hold no texture"));
  std::size_t levels = 0, notFiltered = 0;
  for (const FrameReport::ProbeUse& probe : report.probes) {
    levels += probe.levels;
    notFiltered += probe.notFiltered;
  }
  if (notFiltered > 0) {
    const Phrase line = notFiltered == 1 ? Phrase::tr("%1 mip level of %2 not filtered: no material samples it")
                                         : Phrase::tr("%1 mip levels of %2 not filtered: no material samples them");
    lines.push_back(line.arg(std::to_string(notFiltered)).arg(std::to_string(levels)));
  }
  say(drawnObjects(report, [](const Object& o) { return o.unlit; }), Phrase::tr("%1 draw is unlit: no light, no probe"),
      Phrase::tr("%1 draws are unlit: no light, no probe"));
  say(drawnObjects(report, [](const Object& o) { return !o.unlit && o.probes.empty(); }),
      Phrase::tr("%1 draw has no probe: only the sky, no projection"),
      Phrase::tr("%1 draws have no probe: only the sky, no projection"));
  say(drawnObjects(report, [](const Object& o) { return o.probes.size() == 1 && !o.weights; }),
      Phrase::tr("%1 draw has one probe at full weight: no weights computed, no second lookup"),
      Phrase::tr("%1 draws have one probe at full weight: no weights computed, no second lookup"));
  say(drawnObjects(report, [](const Object& o) { return !o.probes.empty() && o.sky <= 0.0; }),
      Phrase::tr("%1 draw leaves nothing to the sky: the sky is not sampled"),
      Phrase::tr("%1 draws leave nothing to the sky: the sky is not sampled"));
  for (const FrameReport::MirrorUse& mirror : report.mirrors) {
    if (mirror.drawn) continue;
    lines.push_back(Phrase::tr("mirror \"%1\" has no picture: %2").arg(mirror.node).arg(mirror.why));
  }
  return lines;
}

std::vector<Phrase> mirrorLines(const FrameReport& report) {
  std::vector<Phrase> lines;
  for (const FrameReport::MirrorUse& mirror : report.mirrors) {
    if (!mirror.drawn) continue;
    const Phrase moving = mirror.objects == 1 ? Phrase::tr("%1 object that moves") : Phrase::tr("%1 objects that move");
    const Phrase hiding = mirror.hiding == 1 ? Phrase::tr("%1 object that may hide them in depth alone")
                                             : Phrase::tr("%1 objects that may hide them in depth alone");
    lines.push_back(Phrase::tr("\"%1\": %2 x %3 texels, %4, %5")
                        .arg(mirror.node)
                        .arg(std::to_string(mirror.width))
                        .arg(std::to_string(mirror.height))
                        .arg(moving.arg(std::to_string(mirror.objects)))
                        .arg(hiding.arg(std::to_string(mirror.hiding))));
  }
  return lines;
}

std::vector<Phrase> leftOutLines(const FrameReport& report) {
  std::vector<Phrase> lines;
  for (const FrameReport::Object& object : report.objects) {
    if (object.leftOut > 0) {
      const Phrase line =
          object.leftOut == 1
              ? Phrase::tr(
                    "objects.%1: %2 probe beyond the %3 most important ones reach it and are left out; divide the "
                    "object, or raise importance where it counts")
              : Phrase::tr(
                    "objects.%1: %2 probes beyond the %3 most important ones reach it and are left out; divide "
                    "the object, or raise importance where it counts");
      lines.push_back(
          line.arg(object.node).arg(std::to_string(object.leftOut)).arg(std::to_string(object.probes.size())));
    }
    if (!object.givenUp.empty()) {
      lines.push_back(
          Phrase::tr("objects.%1: this OpenGL driver has too few texture units for its probes and textures; "
                     "%2")
              .arg(object.node)
              .arg(object.givenUp));
    }
  }
  return lines;
}

}  // namespace boxprobe
