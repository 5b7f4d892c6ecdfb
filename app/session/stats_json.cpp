// See stats_json.h.
#include "app/session/stats_json.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/session/valid_json.h"
#include "filters/io/image/image_pool.h"
#include "filters/platform/process.h"
#include "filters/vtk/gl/software_driver.h"

namespace boxprobe {

namespace {

using Json = nlohmann::ordered_json;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

Json orNull(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace

RunStats collectStats(const SceneRenderer& renderer, vtkOpenGLRenderWindow* window) {
  RunStats stats;
  stats.counters = renderer.counters();
  stats.times = renderer.times();
  stats.probeBytes = renderer.probeMemoryBytes();
  stats.glRenderer = window->GetState()->GetRenderer();
  stats.glVersion = window->GetState()->GetVersion();
  stats.anisotropy = static_cast<int>(textureAnisotropy());
  return stats;
}

std::string statsJson(const RunStats& stats) {
  const Counters& c = stats.counters;
  const std::vector<double>& frames = stats.frameCpuSeconds;
  Json json;
  json["counters"] = {{"facesCaptured", c.facesCaptured},
                      {"coarseFaces", c.coarseFaces},
                      {"opennessRays", c.opennessRays},
                      {"facesReused", c.facesReused},
                      {"mapsLoaded", c.mapsLoaded},
                      {"skyFacesCaptured", c.skyFacesCaptured},
                      {"levelsFiltered", c.levelsFiltered},
                      {"levelsSkipped", c.levelsSkipped},
                      {"levelsMadeLater", c.levelsMadeLater},
                      {"sightsTraced", c.sightsTraced},
                      {"sightRays", c.sightRays},
                      {"lampsSeenWhole", c.lampsSeenWhole},
                      {"objectsCaptured", c.objectsCaptured},
                      {"objectsCulled", c.objectsCulled},
                      {"objectsUnlit", c.objectsUnlit},
                      {"programsCompiled", c.programsCompiled},
                      {"programsGivenBack", c.programsReleased},
                      {"surfacePrograms", c.surfacePrograms},
                      {"programSwitches", c.programSwitches},
                      {"constantsFolded", c.constantsFolded},
                      {"constantsLeft", c.constantsLeft},
                      {"renders", c.renders},
                      {"drawsByProbeCount", c.drawsByProbeCount},
                      {"drawsLeftOut", c.drawsCulled},
                      {"skyLeftOut", c.skyCulled},
                      {"drawsWithOpenSky", c.drawsWithOpenSky},
                      {"drawsWithCoverage", c.drawsWithCoverage},
                      {"shadowMapsDrawn", c.shadowMapsDrawn},
                      {"glassDraws", c.glassDraws},
                      {"glassPasses", c.glassPasses},
                      {"texelsClamped", c.texelsClamped},
                      {"errorsMeasured", c.errorsMeasured},
                      {"reliefsBounded", c.reliefsBounded},
                      {"sourcesFlattened", c.sourcesFlattened},
                      {"mapsFlattened", c.mapsFlattened},
                      {"texelsNotFinite", c.texelsNotFinite},
                      {"uniformUpdates", c.uniformUpdates}};
  const MirrorCounters& m = c.mirrors;
  json["counters"]["mirrors"] = {{"drawn", m.drawn},
                                 {"texels", m.texels},
                                 {"disabled", m.disabled},
                                 {"rough", m.rough},
                                 {"facingAway", m.facingAway},
                                 {"notInView", m.notInView},
                                 {"nothingDynamic", m.nothingDynamic},
                                 {"overBudget", m.overBudget}};
  const ImageCounts images = imagePool().counts();
  json["counters"]["imagesDecoded"] = images.decoded;
  json["counters"]["imagesShared"] = images.shared;
  Json& times = json["times"];
  times["startToFirstFrameCpuSeconds"] = orNull(stats.startToFirstFrameCpuSeconds);
  times["modelLoadCpuSeconds"] = orNull(stats.modelLoadCpuSeconds);
  times["captureCpuSeconds"] = stats.times.captureCpuSeconds;
  times["prefilterCpuSeconds"] = stats.times.prefilterCpuSeconds;
  times["bounces"] = Json::array();
  for (const BounceCost& bounce : stats.times.bounces) {
    times["bounces"].push_back({{"faces", bounce.faces}, {"cpuSeconds", bounce.cpuSeconds}});
  }
  times["frameCpuSecondsMedian"] = frames.empty() ? Json(nullptr) : Json(median(frames));
  times["frameCpuSecondsMin"] = frames.empty() ? Json(nullptr) : Json(*std::min_element(frames.begin(), frames.end()));
  times["frames"] = frames.size();
  json["memoryBytes"] = {{"probes", stats.probeBytes}, {"peakResident", peakResidentBytes()}};
  json["gl"] = {{"renderer", stats.glRenderer}, {"version", stats.glVersion}, {"anisotropy", stats.anisotropy}};
  return validJson(json);
}

}  // namespace boxprobe
