// See shown_parts.h.
#include "app/gui/view/shown_parts.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "app/gui/handles/scene_surfaces.h"
#include "app/gui/widgets/preferences.h"
#include "filters/core/geometry/model_placement.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

using Part = ViewState::Part;

namespace {

/// Has the mesh a triangle whose bounds, in the probe's frame, meet its box? What stands around a box, such as hills,
/// has bounds that contain it.
bool reachesInto(const Mesh& mesh, const glm::dmat4& worldFromMesh, const Probe& probe) {
  const glm::dmat3 boxFromWorld = glm::transpose(rotationMatrix(probe.rotationDegrees));
  const glm::dvec3 center = probe.box.center(), half = 0.5 * probe.box.size();
  for (std::size_t at = 0; at + 2 < mesh.indices.size(); at += 3) {
    glm::dvec3 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    for (std::size_t corner = at; corner < at + 3; ++corner) {
      const glm::dvec3 world(worldFromMesh * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[corner]]), 1.0));
      const glm::dvec3 inBox = boxFromWorld * (world - center);
      low = glm::min(low, inBox);
      high = glm::max(high, inBox);
    }
    if (glm::all(glm::lessThanEqual(low, half)) && glm::all(glm::lessThanEqual(-half, high))) return true;
  }
  return false;
}

}  // namespace

ShownParts::ShownParts(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {
  parts.state.setCutaway(cutsAway());
  connect(&parts.state, &ViewState::changed, this, &ShownParts::update);
  // Whatever selects a probe.
  connect(&parts.editor, &Editor::selectionChanged, this, [this] { parts_.state.selectObjects({}); });
}

void ShownParts::documentChanged(const Changes& changes) {
  ViewState& state = parts_.state;
  if (changes.probeList || changes.models) state.follow(parts_.editor.scene().probes, parts_.nodes);
  const bool others = changes.probeList || changes.selection || changes.objects || changes.models;
  if (others || state.cutaway()) update();
}

void ShownParts::update() {
  const ViewState& state = parts_.state;
  WindowView view;
  if (!whole_) {
    if (state.isolated() || state.anyHidden()) {
      for (const std::string& node : parts_.nodes) {
        if (!state.shown(Part::Object, node)) view.hidden.insert(node);
      }
    }
    const Probe* probe = parts_.editor.probe();
    if (state.cutaway() && probe != nullptr) view.cutaway = CutBox{probe->box, probe->rotationDegrees};
  }
  view.outlined = state.objects();
  ViewState::Names locked;
  if (state.anyLocked()) {
    for (const std::string& node : parts_.nodes) {
      if (state.locked(Part::Object, node)) locked.insert(node);
    }
  }
  parts_.surfaces.setView({view.hidden, locked, view.cutaway});
  if (view == parts_.renderer.windowView()) return;
  parts_.renderer.setWindowView(view);
  emit pictureChanged();
}

void ShownParts::setWhole(bool whole) {
  if (whole == whole_) return;
  whole_ = whole;
  update();
}

ViewState::Names ShownParts::selectedProbes() const {
  ViewState::Names names;
  for (const std::size_t index : parts_.editor.selected()) names.insert(parts_.editor.scene().probes[index].name);
  return names;
}

void ShownParts::hideSelected() {
  const ViewState::Names objects = parts_.state.objects();
  const ViewState::Names probes = objects.empty() ? selectedProbes() : ViewState::Names();
  if (objects.empty() && probes.empty()) return emit message(tr("Select a probe or an object to hide"));
  setHidden(probes, objects, true);
}

void ShownParts::setHidden(const ViewState::Names& probes, const ViewState::Names& objects, bool hidden) {
  parts_.state.endIsolation();
  parts_.state.setHidden(Part::Probe, probes, hidden);
  parts_.state.setHidden(Part::Object, objects, hidden);
  if (!hidden) return;
  ViewState::Names names = probes;
  names.insert(objects.begin(), objects.end());
  emit message(names.size() == 1
                   ? tr("%1 is hidden in this window; Alt+H shows it").arg(QString::fromStdString(*names.begin()))
                   : tr("%1 items are hidden in this window; Alt+H shows them").arg(static_cast<int>(names.size())));
}

ViewState::Names ShownParts::objectsIn(const std::vector<std::size_t>& probes) const {
  const Scene& scene = parts_.editor.scene();
  const auto& models = parts_.models;
  ViewState::Names names;
  for (std::size_t i = 0; i < models.size() && i < scene.models.size(); ++i) {
    for (const Instance& instance : models[i]->instances) {
      if (names.count(instance.node) > 0) continue;
      const glm::dmat4 place =
          movedInstance(worldFromFile(scene.models[i]) * instance.worldFromModel, scene, instance.node);
      const Mesh& mesh = models[i]->meshes[static_cast<std::size_t>(instance.mesh)];
      const bool in = std::any_of(probes.begin(), probes.end(),
                                  [&](std::size_t index) { return reachesInto(mesh, place, scene.probes[index]); });
      if (in) names.insert(instance.node);
    }
  }
  return names;
}

void ShownParts::toggleIsolation() {
  if (parts_.state.isolated()) return isolate({}, {});
  const ViewState::Names probes = selectedProbes();
  ViewState::Names objects = parts_.state.objects();
  if (objects.empty()) {
    if (probes.empty()) return emit message(tr("Select a probe or an object to isolate"));
    objects = objectsIn(parts_.editor.selected());
  }
  isolate(probes, objects);
}

void ShownParts::isolate(const ViewState::Names& probes, const ViewState::Names& objects) {
  if (parts_.state.isolated()) return parts_.state.endIsolation();
  parts_.state.isolate(probes, objects);
  emit message(tr("Only the selection is shown; press / to show the rest"));
}

void ShownParts::setCutaway(bool on) {
  keepCutaway(on);
  parts_.state.setCutaway(on);
}

}  // namespace boxprobe
