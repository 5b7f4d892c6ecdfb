#include "app/session/probe_captures.h"

#include <filesystem>
#include <memory>

#include "app/session/interrupt.h"
#include "app/session/offscreen_scene.h"
#include "app/session/scene_work.h"
#include "filters/core/base/errors.h"
#include "filters/io/cube/bake_folder.h"

namespace boxprobe {

namespace {

ProbeCapture fromPicture(const Probe& probe) {
  const LoadedCube cube = loadCustomCube(probe, probe.faceSize);
  ProbeCapture capture;
  capture.probe = probe;
  capture.level0 = cube.radiance;
  capture.clamped = cube.repairs.beyondHalf > 0;
  std::array<std::vector<float>, 6> faces;
  const auto size = static_cast<std::size_t>(cube.radiance.faceSize());
  for (int face = 0; face < 6; ++face) {
    const float* texels = cube.radiance.face(0, face);
    faces[static_cast<std::size_t>(face)].assign(texels, texels + size * size * 4);
  }
  capture.irradiance = irradianceCoefficients(faces, cube.radiance.faceSize());
  return capture;
}

ProbeCapture fromMaps(const Probe& probe, const BakedMaps& maps) {
  ProbeCapture capture;
  capture.probe = probe;
  capture.level0 = maps.radiance;
  capture.irradiance = maps.irradiance;
  capture.capturedRotation = maps.capturedRotation;
  return capture;
}

}  // namespace

CapturedProbes captureProbes(const LoadedScene& loaded, const CaptureWishes& wishes, const InterruptGuard& interrupt) {
  Scene scene = loaded.scene;
  std::vector<std::string> targets;
  for (const std::string& name : wishes.probes) {
    Probe& probe = scene.probes[*findProbe(scene, name)];
    if (probe.mode == ProbeMode::Custom) continue;
    probe.mode = ProbeMode::Baked;
    targets.push_back(name);
  }
  std::unique_ptr<OffscreenScene> shown;
  if (!targets.empty()) {
    shown = std::make_unique<OffscreenScene>(OffscreenSettings{"boxprobe export", 16, 16, 1, wishes.quiet, false,
                                                               wishes.offscreen, drawsLittle(1, targets.size())});
    ShownSettings settings;
    settings.bakedFolder = wishes.bakedFolder;
    settings.bakeTargets = targets;
    shown->show(scene, loaded.models, settings);
    captureShown(*shown, interrupt, wishes.quiet);
  }
  CapturedProbes captured;
  std::vector<ProbeCapture>& captures = captured.captures;
  for (const std::string& name : wishes.probes) {
    const Probe& probe = scene.probes[*findProbe(scene, name)];
    if (probe.mode == ProbeMode::Custom) {
      captures.push_back(fromPicture(probe));
    } else if (const auto maps = shown->renderer().mapsOnCpu(name)) {
      captures.push_back(fromMaps(probe, *maps));
    } else {  // its file holds: nothing was captured
      const auto path = std::filesystem::path(wishes.bakedFolder) / BakeFolder::fileName(name);
      captures.push_back(fromMaps(probe, loadBakedProbe(path.string()).maps));
    }
  }
  if (shown) captured.stats = collectStats(shown->renderer(), shown->window());
  return captured;
}

}  // namespace boxprobe
