// See frame_info.h.
#include "app/cli/report/frame_info.h"

#include <algorithm>
#include <cstdio>

#include "app/session/automatic_exposure.h"
#include "app/session/interrupt.h"
#include "app/session/offscreen_scene.h"
#include "app/session/opened_glb.h"
#include "app/session/progress_line.h"
#include "app/session/scene_work.h"

namespace boxprobe {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kRounds = 7;           // of every kind of frame
constexpr std::size_t kListed = 40;  // lines of a kind, for people

std::string formatted(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string drawnObjectLine(const FrameReport::Object& object) {
  std::string line = "  " + object.node;
  if (!object.drawn) return line + ": not drawn";
  if (object.unlit) return line + ": unlit";
  line += ":";
  for (const FrameReport::Share& share : object.probes) {
    line += " " + share.probe + formatted(" %.0f %%,", 100.0 * share.weight);
  }
  return line + formatted(" sky %.0f %%", 100.0 * object.sky);
}

// Of a picture at rest, as a window draws it after a while.
FrameCosts measuredCosts(OffscreenScene& shown, const InterruptGuard& interrupt, bool quiet) {
  shown.rest();
  ProgressLine line("measuring costs", !quiet);
  FrameCosts costs = measureFrameCosts(
      shown.renderer(), kRounds, [&] { return timedFrameOf(shown.window()); },
      [&](double fraction) {
        line.show(fraction);
        return !interrupt.interrupted();
      });
  interrupt.check();
  return costs;
}

}  // namespace

FrameReport drawnFrameReport(LoadedScene& loaded, const std::string& scenePath, const std::string& camera,
                             FrameSize frame, const ReportOptions& options, FrameCosts* costs) {
  const Camera view = chooseCamera(loaded.scene, camera);
  const InterruptGuard interrupt;
  OffscreenScene shown(
      {"boxprobe info --frame", frame.width, frame.height, 1, options.quiet, false, options.offscreen});
  ShownSettings settings{view};
  settings.bakedFolder = bakedFolderOf(scenePath);
  shown.show(loaded.scene, loaded.models, settings);
  captureShown(shown, interrupt, options.quiet);
  exposeAutomatically(shown, loaded, settings, static_cast<double>(frame.width) / frame.height);
  shown.window()->Render();
  shown.requireHealthy();
  FrameReport report = shown.renderer().frameReport();
  report.lookups = shown.renderer().measureLookups(frame.width, frame.height);
  if (costs != nullptr) *costs = measuredCosts(shown, interrupt, options.quiet);
  shown.requireHealthy();
  return report;
}

Json frameReportJson(const FrameReport& report) {
  Json json;
  json["drawsByProbeCount"] = report.drawsByProbeCount;
  json["variants"] = report.variants;
  if (report.lookups) {
    json["lookupsPerPixelMean"] = report.lookups->mean;
    json["lookupsPerPixelMax"] = report.lookups->most;
  }
  json["memoryBytes"] = report.bytes;
  json["mirrorBytes"] = report.mirrorBytes;
  json["skipped"] = english(skippedLines(report));
  json["mirrors"] = Json::array();
  for (const FrameReport::MirrorUse& mirror : report.mirrors) {
    json["mirrors"].push_back({{"name", mirror.node},
                               {"drawn", mirror.drawn},
                               {"why", mirror.why.english()},
                               {"width", mirror.width},
                               {"height", mirror.height},
                               {"objects", mirror.objects},
                               {"hiding", mirror.hiding}});
  }
  json["leftOut"] = english(leftOutLines(report));
  json["objects"] = Json::array();
  for (const FrameReport::Object& object : report.objects) {
    Json shares = Json::object();
    for (const FrameReport::Share& share : object.probes) shares[share.probe] = share.weight;
    json["objects"].push_back({{"name", object.node},
                               {"material", object.material},
                               {"drawn", object.drawn},
                               {"probes", shares},
                               {"sky", object.sky},
                               {"leftOut", object.leftOut}});
  }
  json["probes"] = Json::array();
  for (const FrameReport::ProbeUse& probe : report.probes) {
    json["probes"].push_back(
        {{"name", probe.name}, {"objects", probe.objects}, {"drawn", probe.drawn}, {"memoryBytes", probe.bytes}});
  }
  return json;
}

std::string frameReportText(const FrameReport& report) {
  std::string text = "frame\n  draws with 0, 1, 2, 3, 4 probes:";
  for (const std::size_t draws : report.drawsByProbeCount) text += " " + std::to_string(draws);
  text += "\n  shader variants: " + std::to_string(report.variants) + "\n";
  if (report.lookups) {
    text += "  lookups per pixel:" + formatted(" mean %.3f,", report.lookups->mean) +
            formatted(" at most %.0f\n", report.lookups->most);
  }
  text += "  maps: " + formatted("%.1f MiB\n", static_cast<double>(report.bytes) / 1048576.0);
  const std::vector<std::string> mirrors = english(mirrorLines(report));
  if (!mirrors.empty()) text += "planar mirrors\n";
  for (const std::string& line : mirrors) text += "  " + line + "\n";
  text += "skipped in the frame\n";
  for (const std::string& line : english(skippedLines(report))) text += "  " + line + "\n";
  for (const std::string& line : english(leftOutLines(report))) text += "  " + line + "\n";
  text += "probes of the drawn objects, by share of their bounds\n";
  std::size_t listed = 0;
  for (const FrameReport::Object& object : report.objects) {
    if (object.drawn && ++listed <= kListed) text += drawnObjectLine(object) + "\n";
  }
  if (listed > kListed) text += "  and " + std::to_string(listed - kListed) + " more; --json has them\n";
  text += "memory by probe\n";
  std::vector<FrameReport::ProbeUse> held;
  for (const FrameReport::ProbeUse& probe : report.probes) {
    if (probe.bytes > 0) held.push_back(probe);
  }
  std::stable_sort(held.begin(), held.end(), [](const auto& a, const auto& b) { return a.bytes > b.bytes; });
  for (std::size_t i = 0; i < held.size() && i < kListed; ++i) {
    text += "  " + held[i].name + ": " + formatted("%.2f MiB", static_cast<double>(held[i].bytes) / 1048576.0) +
            ", lights " + std::to_string(held[i].objects) + " objects, " + std::to_string(held[i].drawn) +
            " of them drawn\n";
  }
  return text;
}

}  // namespace boxprobe
