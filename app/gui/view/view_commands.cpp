// See view_commands.h.
#include "app/gui/view/view_commands.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "app/gui/handles/scene_surfaces.h"
#include "app/gui/view/camera_moves.h"
#include "app/gui/view/framing.h"
#include "app/gui/view/viewport.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

bool cameraNamed(const Scene& scene, const std::string& name) {
  return std::any_of(scene.cameras.begin(), scene.cameras.end(), [&](const Camera& c) { return c.name == name; });
}

}  // namespace

ViewCommands::ViewCommands(Editor& editor, const ViewState& state, SceneRenderer& renderer, Viewport& viewport,
                           SceneSurfaces& surfaces, QObject* parent)
    : QObject(parent), editor_(editor), state_(state), renderer_(renderer), viewport_(viewport), surfaces_(surfaces) {
  connect(&viewport, &Viewport::cameraMoved, this, &ViewCommands::forgetHint);
}

void ViewCommands::forgetHint() {
  if (std::exchange(hinted_, false)) emit message({});
}

double ViewCommands::aspect() const {
  return viewport_.height() > 0 ? static_cast<double>(viewport_.width()) / viewport_.height() : 1.0;
}

Box ViewCommands::selectedBounds() const {
  std::optional<Box> objects;
  for (const std::string& node : state_.objects()) {
    const auto one = renderer_.objectBounds(node);
    if (!one) continue;
    objects = objects ? Box{glm::min(objects->min, one->min), glm::max(objects->max, one->max)} : *one;
  }
  if (objects) return *objects;
  const std::vector<std::size_t> selected = editor_.selected();
  if (selected.empty()) return renderer_.bounds();
  const auto& probes = editor_.scene().probes;
  Box bounds = worldBoundsOf(probes[selected.front()]);
  for (const std::size_t index : selected) {
    const Box one = worldBoundsOf(probes[index]);
    bounds = {glm::min(bounds.min, one.min), glm::max(bounds.max, one.max)};
  }
  return bounds;
}

void ViewCommands::frameSelection() {
  vtkCamera* camera = renderer_.renderer()->GetActiveCamera();
  const Box bounds = selectedBounds();
  const bool any = !state_.objects().empty() || !editor_.selected().empty();
  const MeetSurface meet = [this](const Ray& ray) { return surfaces_.meet(ray); };
  const bool indoors = any && isIndoors(eyeOf(camera), meet) && isIndoors(bounds.center(), meet);
  frameBox(camera, bounds, aspect());
  bool hidden = false;
  if (any && camera->GetParallelProjection() == 0 && !state_.cutaway()) {
    const auto clear = clearDistance(camera, bounds, meet);
    if (clear && indoors) {
      const glm::dvec3 eye = bounds.center() - *clear * forwardOf(camera);
      camera->SetPosition(eye.x, eye.y, eye.z);
    } else if (clear) {
      hidden = true;
    }
  }
  emit cameraMoved();
  if (!hidden) return;
  hinted_ = true;
  emit message(tr("A wall hides the selection; Alt+B cuts it away"));
}

void ViewCommands::lookAlong(const BoxFace& face) {
  vtkCamera* camera = renderer_.renderer()->GetActiveCamera();

  viewport_.cameraController().setAxisView(camera->GetViewAngle());
  boxprobe::lookAlong(camera, face, selectedBounds(), aspect());
  emit cameraMoved();
}

void ViewCommands::lookFromProbe() {
  const Probe* probe = editor_.probe();
  if (probe == nullptr) return;
  Camera camera = current("");
  camera.parallelHeight = 0.0;
  glm::dvec3 ahead = camera.target - camera.position;
  // An axis view may look straight down, which no upright camera does.
  if (glm::length(glm::cross(glm::normalize(ahead), glm::dvec3(0.0, 1.0, 0.0))) < 0.05) ahead = {0.0, 0.0, -1.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.position = probe->origin;
  camera.target = probe->origin + glm::normalize(ahead);
  renderer_.applyCamera(camera);
  emit cameraMoved();
}

void ViewCommands::lookAtSpot(const glm::dvec3& positionWorld, const glm::dvec3& eyeWorld) {
  constexpr double kFar = 0.35;  // of the scene: near enough to see the spot, far enough to see what is about it
  const glm::dvec3 away = eyeWorld - positionWorld;
  const double distance = glm::length(away);
  if (!(distance > 0.0)) return;
  if (!before_) before_ = current("");
  Camera camera = current("");
  camera.parallelHeight = 0.0;
  camera.target = positionWorld;
  camera.position = positionWorld + away * std::min(1.0, kFar * glm::length(renderer_.bounds().size()) / distance);
  // Looking straight down, up on the screen is any way.
  const bool upright = std::abs(away.y) < 0.999 * distance;
  camera.up = upright ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, -1.0);
  renderer_.applyCamera(camera);
  emit cameraMoved();
  emit canComeBack(true);
}

void ViewCommands::comeBack() {
  if (!before_) return;
  renderer_.applyCamera(*before_);
  before_.reset();
  emit cameraMoved();
  emit canComeBack(false);
}

void ViewCommands::forgetView() {
  before_.reset();
  emit canComeBack(false);
}

void ViewCommands::setWalking(bool on) {
  viewport_.cameraController().setWalking(on);
}

Camera ViewCommands::current(const std::string& name) const {
  Camera camera = renderer_.currentCamera();
  camera.name = name;
  return camera;
}

void ViewCommands::storeCamera(const QString& name) {
  const std::string stem = name.trimmed().isEmpty() ? "view" : name.trimmed().toStdString();
  std::string unused = stem;
  for (int number = 2; cameraNamed(editor_.scene(), unused); ++number) unused = stem + " " + std::to_string(number);
  const Camera camera = current(unused);
  editor_.commit(tr("Store camera %1").arg(QString::fromStdString(unused)),
                 [camera](Scene& scene) { scene.cameras.push_back(camera); });
}

void ViewCommands::updateCamera(int index) {
  const auto at = static_cast<std::size_t>(index);
  if (at >= editor_.scene().cameras.size()) return;
  const Camera camera = current(editor_.scene().cameras[at].name);
  editor_.commit(tr("Move camera %1 here").arg(QString::fromStdString(camera.name)),
                 [camera, at](Scene& scene) { scene.cameras[at] = camera; });
}

void ViewCommands::renameCamera(int index, const QString& name) {
  const auto at = static_cast<std::size_t>(index);
  const std::string now = name.trimmed().toStdString();
  if (at >= editor_.scene().cameras.size() || now == editor_.scene().cameras[at].name) return;
  if (now.empty()) return emit editor_.failed(tr("A camera needs a name"));
  if (cameraNamed(editor_.scene(), now)) {
    return emit editor_.failed(tr("A camera named %1 already exists; each needs its own name").arg(name.trimmed()));
  }
  editor_.commit(tr("Rename camera to %1").arg(name.trimmed()),
                 [now, at](Scene& scene) { scene.cameras[at].name = now; });
}

void ViewCommands::deleteCamera(int index) {
  const auto at = static_cast<std::size_t>(index);
  if (at >= editor_.scene().cameras.size()) return;
  editor_.commit(tr("Delete camera %1").arg(QString::fromStdString(editor_.scene().cameras[at].name)),
                 [at](Scene& scene) { scene.cameras.erase(scene.cameras.begin() + static_cast<std::ptrdiff_t>(at)); });
}

}  // namespace boxprobe
