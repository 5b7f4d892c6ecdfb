// See probe_commands.h.
#include "app/gui/panels/probe_commands.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <numeric>
#include <utility>

#include "app/gui/edit/probe_copies.h"
#include "app/gui/handles/scene_surfaces.h"
#include "app/gui/view/workspace.h"
#include "app/session/fit_scene.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

Probe newProbe(const Scene& scene, const Box& bounds, const glm::dvec3& originWorld) {
  Probe probe = fittedProbe(bounds);
  probe.name = unusedProbeName(scene, "probe");
  // Looking past the scene must not put the origin outside of what it captures.
  probe.origin = glm::clamp(originWorld, bounds.min + 0.05 * bounds.size(), bounds.max - 0.05 * bounds.size());
  return probe;
}

/// Where the camera looks at. From within the scene never behind or in what it sees there: half way to that.
glm::dvec3 lookedAt(const Camera& camera, const Box& bounds, const SurfaceRays* rays) {
  const double distance = glm::distance(camera.position, camera.target);
  const bool within =
      glm::all(glm::lessThan(bounds.min, camera.position)) && glm::all(glm::lessThan(camera.position, bounds.max));
  if (!within || rays == nullptr || !(distance > 0.0)) return camera.target;
  const glm::dvec3 along = (camera.target - camera.position) / distance;
  const std::optional<SurfaceHit> hit = rays->first(camera.position, along);
  return hit && hit->distance <= distance ? camera.position + 0.5 * hit->distance * along : camera.target;
}

}  // namespace

ProbeCommands::ProbeCommands(Workspace& workspace, QObject* parent)
    : QObject(parent), workspace_(workspace), editor_(workspace.editor()) {
  connect(workspace.actions().addProbe, &QAction::triggered, this, &ProbeCommands::addProbe);
}

void ProbeCommands::addProbe() {
  editor_.finish();
  if (editor_.scene().models.empty()) {
    return emit editor_.failed(tr("There is nothing to capture yet: open a model or a scene first (Ctrl+O)"));
  }
  const SceneRenderer& renderer = workspace_.renderer();
  const glm::dvec3 origin = lookedAt(renderer.currentCamera(), renderer.bounds(), workspace_.surfaces().rays());
  const Probe probe = newProbe(editor_.scene(), renderer.bounds(), origin);
  editor_.commit(tr("Add %1").arg(QString::fromStdString(probe.name)),
                 [probe](Scene& scene) { scene.probes.push_back(probe); });
  editor_.selectProbe(findProbe(editor_.scene(), probe.name));
  emit added();
}

// The copies stand together behind the last of what they are of.
void ProbeCommands::duplicateProbe() {
  editor_.finish();
  const std::vector<std::size_t> selected = editor_.selected();
  if (selected.empty()) return;
  const QString from = editor_.selectedName();
  std::vector<Probe> all = editor_.scene().probes, made;
  ProbeCopies copy(editor_.scene());
  for (const std::size_t index : selected) made.push_back(copy.add(all[index]));
  const std::size_t at = selected.back() + 1;
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(at), made.begin(), made.end());
  std::vector<std::size_t> copies(made.size());
  std::iota(copies.begin(), copies.end(), at);
  editor_.commit(tr("Duplicate %1").arg(from), [all](Scene& scene) { scene.probes = all; });
  editor_.selectProbes(copies);
}

void ProbeCommands::deleteProbe() {
  editor_.finish();
  const std::vector<std::size_t> selected = editor_.selected();
  if (selected.empty()) return;
  editor_.commit(tr("Delete %1").arg(editor_.selectedName()), [selected](Scene& scene) {
    for (auto index = selected.rbegin(); index != selected.rend(); ++index) {
      scene.probes.erase(scene.probes.begin() + static_cast<std::ptrdiff_t>(*index));
    }
  });
  const std::size_t left = editor_.scene().probes.size();
  if (left > 0) editor_.selectProbe(std::min(selected.front(), left - 1));
}

void ProbeCommands::rename(std::size_t index, const QString& name) {
  const auto& probes = editor_.scene().probes;
  if (index >= probes.size()) return;
  const std::string from = probes[index].name;
  const QString to = name.trimmed();
  const auto holder = findProbe(editor_.scene(), to.toStdString());
  if (to.isEmpty()) {
    emit editor_.failed(tr("A probe needs a name; it stays %1").arg(QString::fromStdString(from)));
  } else if (holder && *holder != index) {
    emit editor_.failed(tr("A probe named %1 already exists; each needs its own name").arg(to));
  } else if (to.toStdString() != from) {
    const std::string now = to.toStdString();
    editor_.commit(tr("Rename %1 to %2").arg(QString::fromStdString(from), to),
                   [index, now](Scene& scene) { scene.probes[index].name = now; });
    const std::vector<std::size_t> selected = editor_.selected();
    if (std::find(selected.begin(), selected.end(), index) == selected.end()) editor_.selectProbe(index);
  }
}

}  // namespace boxprobe
