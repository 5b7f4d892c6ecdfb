// See view_tools.h.
#include "app/gui/window/view_tools.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QLabel>
#include <QMainWindow>
#include <algorithm>

#include "app/gui/view/axis_gizmo.h"
#include "app/gui/view/compare_wipe.h"
#include "app/gui/view/picture_compare.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/shown_parts.h"
#include "app/gui/view/sky_turn.h"
#include "app/gui/view/view_comparison.h"
#include "app/gui/view/viewport.h"
#include "app/gui/view/whole_view.h"
#include "app/gui/view/workspace.h"
#include "app/gui/window/exposure_tools.h"
#include "app/gui/window/key_list.h"
#include "app/gui/window/picture_menu.h"
#include "app/gui/window/probe_clipboard.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/scope_exit.h"
#include "filters/vtk/scene_renderer.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"

namespace boxprobe {

ViewTools::ViewTools(Workspace& workspace, QMainWindow* window)
    : QObject(window),
      workspace_(workspace),
      pictureMenu_(new PictureMenu(workspace, window)),
      compare_(new PictureCompare(
          workspace.document(), *new CompareWipe(&workspace.viewport()),
          {[this] { return workspace_.atRest(); }, [this] { return barePicture(); },
           [this](const QSize& size) { return bareLight(size); },
           [this] { return workspace_.renderer().currentCamera(); }, [this] { return workspace_.models(); },
           [this] { return workspace_.renderer().probesDiffuse(); }},
          this)),
      sideBySide_(new ViewComparison(
          workspace.document(), &workspace.viewport(),
          {[this] { return workspace_.atRest(); }, [this] { return barePicture(); },
           [this](const QSize& size) { return bareLight(size); },
           [this] { return workspace_.renderer().currentCamera(); }, [this] { return workspace_.models(); },
           [this](const Scene& scene, const Changes& changes) {
             workspace_.renderer().sync(scene, changes);
             workspace_.scheduler().sceneChanged();
           }},
          this)) {
  new AxisGizmo(workspace);
  new SkyTurn(workspace, this);
  new ProbeClipboard(workspace, this);
  new ExposureTools(workspace, window);
  connectCompare();
  connectSideBySide();
  connect(workspace.actions().keys, &QAction::toggled, this, &ViewTools::showKeys);
}

ViewCommands& ViewTools::views() const {
  return workspace_.views();
}

void ViewTools::connectCompare() {
  const Actions& actions = workspace_.actions();
  workspace_.listenTo(compare_);
  connect(actions.hold, &QAction::triggered, compare_, &PictureCompare::hold);
  connect(actions.trace, &QAction::triggered, compare_, [this] { compare_->traceReference(TracedLight::All); });
  connect(actions.traceReflection, &QAction::triggered, compare_,
          [this] { compare_->traceReference(TracedLight::Reflection); });
  connect(actions.traceError, &QAction::triggered, compare_, &PictureCompare::traceError);
  connect(actions.difference, &QAction::toggled, compare_, &PictureCompare::setDifference);
  connect(compare_, &PictureCompare::differenceChanged, actions.difference, &QAction::setChecked);
  connect(actions.flip, &QAction::toggled, compare_, &PictureCompare::setFlipped);
  connect(actions.stopComparing, &QAction::triggered, compare_, &PictureCompare::stop);
  connect(compare_, &PictureCompare::activeChanged, this, [this](bool active) {
    if (active) sideBySide_->setOn(false);
    comparisonChanged();
  });
  connect(&workspace_.scheduler(), &RenderScheduler::rendered, compare_, &PictureCompare::pictureDrawn);
  connect(&workspace_.editor(), &Editor::settled, compare_, &PictureCompare::documentChanged);
  comparisonChanged();
}

void ViewTools::connectSideBySide() {
  const Actions& actions = workspace_.actions();
  workspace_.listenTo(sideBySide_);
  connect(actions.sideBySide, &QAction::toggled, sideBySide_, &ViewComparison::setOn);
  connect(sideBySide_, &ViewComparison::onChanged, this, [this](bool on) {
    workspace_.actions().sideBySide->setChecked(on);
    if (on) compare_->stop();
    comparisonChanged();
  });
  connect(&workspace_.scheduler(), &RenderScheduler::rendered, sideBySide_, &ViewComparison::pictureDrawn);
  connect(sideBySide_, &ViewComparison::ownSceneShown, &workspace_, &Workspace::documentSceneDrawn);
  connect(&workspace_, &Workspace::lookChanged, sideBySide_, &ViewComparison::pictureChanged);
  connect(&workspace_, &Workspace::documentSceneWanted, sideBySide_, [this] { sideBySide_->setOn(false); });
  connect(&workspace_, &Workspace::posesChanged, sideBySide_, &ViewComparison::forget);
}

void ViewTools::comparisonChanged() {
  const Actions& actions = workspace_.actions();
  const bool active = compare_->active();
  for (QAction* action : {actions.flip, actions.difference}) {
    if (!active) action->setChecked(false);
    action->setEnabled(active);
  }
  actions.stopComparing->setEnabled(active);
  // What is measured beside the picture has everything, too.
  workspace_.shown().setWhole(active || sideBySide_->on());
}

bool ViewTools::stopComparing() {
  const bool any = compare_->active() || sideBySide_->on();
  compare_->stop();
  sideBySide_->setOn(false);
  return any;
}

QImage ViewTools::barePicture() {
  if (!workspace_.viewport().readyToDraw()) return {};
  workspace_.viewport().window3d()->MakeCurrent();
  ImageRgba8 image;
  try {
    const int shown = workspace_.shownHandles().GetVisibility();
    workspace_.shownHandles().VisibilityOff();
    const ScopeExit again([this, shown] { workspace_.shownHandles().SetVisibility(shown); });
    const WholeView whole(workspace_.renderer());
    image = workspace_.renderer().renderDisplay();
  } catch (const Error& error) {
    emit workspace_.failed(QString::fromUtf8(error.what()));
    return {};
  }
  workspace_.viewport().window3d()->Render();  // the handles again
  const QImage shared(image.pixels.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888);
  return shared.convertToFormat(QImage::Format_RGB32);
}

ImageRgbaF ViewTools::bareLight(const QSize& size) {
  if (!workspace_.viewport().readyToDraw()) return {};
  try {
    return workspace_.renderer().renderLinear(size.width(), size.height(), 1);
  } catch (const Error& error) {
    emit workspace_.failed(QString::fromUtf8(error.what()));
    return {};
  }
}

void ViewTools::showKeys(bool shown) {
  if (keys_ == nullptr) {
    keys_ = new QLabel(keyTable(), &workspace_.viewport());
    keys_->setObjectName("keys");
    keys_->setAttribute(Qt::WA_TransparentForMouseEvents);
    keys_->setStyleSheet("QLabel { color: #f4f4f4; background: rgba(16, 18, 22, 225); padding: 10px 14px; }");
    keys_->setWordWrap(true);
  }
  constexpr int kMargin = 8, kWidest = 760;
  keys_->setFixedWidth(std::min(kWidest, workspace_.viewport().width() - 2 * kMargin));
  keys_->adjustSize();
  keys_->move(kMargin, kMargin);
  keys_->raise();
  keys_->setVisible(shown);
}

}  // namespace boxprobe
