// See glb_export.h.
#include "app/session/glb_export.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/session/interrupt.h"
#include "app/session/offscreen_scene.h"
#include "app/session/program_name.h"
#include "app/session/scene_work.h"
#include "filters/core/base/errors.h"
#include "filters/io/cube/bake_folder.h"
#include "filters/io/engines/glb_models.h"
#include "filters/io/engines/glb_probes.h"
#include "filters/io/files/atomic_file.h"
#include "filters/platform/folders.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

/// A new folder, gone at the end with all that is in it.
class ScratchFolder {
 public:
  ScratchFolder() {
    const std::string start = (fs::temp_directory_path() / "boxprobe-export-").string();
    const auto made = makeFolder(start);
    if (!made) throw WorkError(start + "XXXXXX: cannot create this folder");
    name_ = *made;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(name_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

/// A lattice is derived when something that a probe lights is drawn: looks around in each probe until it is.
void drawLattices(OffscreenScene& shown, const Scene& scene) {
  if (scene.lamps != LampForm::Shapes) return;
  constexpr int kSide = 8;
  for (std::size_t i = 0; i < scene.probes.size(); ++i) {
    if (!scene.probes[i].hasLattice()) continue;
    const glm::dvec3 ahead[] = {{0, -1, 0.01}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {0, 0, -1}, {0, 1, 0.01}};
    for (const glm::dvec3& direction : ahead) {
      const ProbesDiffuse now = shown.renderer().probesDiffuse();
      if (i >= now.probes.size() || !now.probes[i] || now.probes[i]->lattice) break;
      Camera camera;
      camera.position = scene.probes[i].origin;
      camera.target = camera.position + direction;
      camera.verticalFovDegrees = 100.0;
      shown.renderer().applyCamera(camera);
      shown.renderer().renderLinear(kSide, kSide, 1);
    }
  }
}

BakedProbeFile unbaked(const Probe& probe, const BakedMaps& maps) {
  BakedProbeFile file;
  file.maps = maps;
  file.info.probe = probe;
  return file;
}

}  // namespace

GlbExporter::GlbExporter(GlbWishes wishes) : wishes_(std::move(wishes)) {}
GlbExporter::~GlbExporter() = default;

std::string GlbExporter::bytes(const LoadedScene& given, const InterruptGuard& interrupt) {
  requireGlbScene(given.scene, wishes_.path);
  // Captured is what will be read from the file, so that its maps hold there.
  const ScratchFolder scratch;
  const bool joins = needsJoining(given.scene);
  const Scene scene = joins ? withJoinedModels(given.scene, given.models, scratch.name()) : given.scene;
  const SceneModels models = joins ? loadModels(scene) : given.models;
  if (!shown_) {
    shown_ = std::make_unique<OffscreenScene>(
        OffscreenSettings{"boxprobe export", 16, 16, 1, wishes_.quiet, false, wishes_.offscreen, false});
  }
  ShownSettings settings;
  settings.bakedFolder = wishes_.bakedFolder;
  for (const Probe& probe : scene.probes) {
    if (probe.mode == ProbeMode::Baked) settings.bakeTargets.push_back(probe.name);
  }
  if (!settings.bakeTargets.empty()) {
    shown_->show(scene, models, settings);
    captureShown(*shown_, interrupt, wishes_.quiet);
    settings.bakeTargets.clear();
  }
  shown_->show(scene, models, settings);
  captureShown(*shown_, interrupt, wishes_.quiet);

  SceneRenderer& renderer = shown_->renderer();
  GlbScene content;
  content.scene = scene;
  content.writer = kProgramName;
  const BakeFolder before(wishes_.bakedFolder);
  for (const Probe& probe : scene.probes) {
    interrupt.check();
    while (renderer.filterMissingLevel(probe.name)) interrupt.check();
    std::string file;
    if (probe.mode == ProbeMode::Baked) {
      const std::vector<std::string> keys = renderer.bakeKeys(probe.name);
      const bool kept = !keys.empty() && before.has(keys.back());
      file = kept ? before.file(keys.back()) : renderer.saveBaked(probe.name, scratch.name(), kProgramName);
    }
    if (!file.empty()) {
      content.maps.emplace_back(loadBakedProbe(file));
    } else if (const auto maps = renderer.mapsOnCpu(probe.name)) {
      content.maps.emplace_back(unbaked(probe, *maps));
    } else {
      content.maps.emplace_back();
    }
  }
  while (renderer.filterMissingLevel({})) interrupt.check();
  if (const std::string file = renderer.saveBaked({}, scratch.name(), kProgramName); !file.empty()) {
    content.sky = loadBakedProbe(file);
  }
  drawLattices(*shown_, scene);
  shown_->requireHealthy();
  content.diffuse = renderer.probesDiffuse();
  written_ = std::make_unique<GlbScene>(std::move(content));
  return glbWithProbes(*written_, models, wishes_.path);
}

std::string GlbExporter::bytesOfBefore(const LoadedScene& loaded) const {
  if (!written_) return {};
  GlbScene content;
  content.scene = loaded.scene;
  content.writer = written_->writer;
  content.sky = written_->sky;
  if (loaded.scene.lights == written_->scene.lights) {
    content.diffuse.countedLights = written_->diffuse.countedLights;  // else they are there as lamps, too
  }
  for (const Probe& probe : loaded.scene.probes) {
    content.maps.emplace_back();
    content.diffuse.probes.emplace_back();
    const auto before = findProbe(written_->scene, probe.name);
    if (!before) continue;
    if (*before < written_->maps.size()) content.maps.back() = written_->maps[*before];
    if (*before < written_->diffuse.probes.size()) content.diffuse.probes.back() = written_->diffuse.probes[*before];
  }
  return glbWithProbes(content, loaded.models, wishes_.path);
}

RunStats GlbExporter::stats() const {
  return shown_ ? collectStats(shown_->renderer(), shown_->window()) : RunStats{};
}

namespace {

std::string revisionFile(const std::string& output) {
  return fs::is_directory(output) ? (fs::path(output) / "revision").string() : output + ".revision";
}

}  // namespace

int lastRevision(const std::string& output) {
  std::ifstream file(revisionFile(output));
  const auto json = nlohmann::json::parse(file, nullptr, false);
  const bool known = json.is_object() && json.contains("revision") && json["revision"].is_number_integer();
  const auto number = known ? json["revision"].get<std::int64_t>() : 0;
  return number > 0 && number < std::numeric_limits<int>::max() / 2 ? static_cast<int>(number) : 0;
}

void writeRevision(const std::string& output, int revision) {
  const bool folder = fs::is_directory(output);
  const nlohmann::ordered_json json = {{"revision", revision},
                                       {"file", folder ? "" : fs::path(output).filename().string()}};
  writeTextAtomically(revisionFile(output), json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace boxprobe
