// See view_tools.h.
#include "app/gui/window/view_tools.h"

#include <vtkGenericOpenGLRenderWindow.h>

#include <QLabel>
#include <QMainWindow>
#include <algorithm>

#include "app/gui/edit/change_views.h"
#include "app/gui/edit/gauge_rows.h"
#include "app/gui/explain/debug_view.h"
#include "app/gui/explain/surface_view_panel.h"
#include "app/gui/handles/face_tags.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/panels/bake_panel.h"
#include "app/gui/panels/fit_panel.h"
#include "app/gui/panels/light_panel.h"
#include "app/gui/panels/outliner.h"
#include "app/gui/view/axis_gizmo.h"
#include "app/gui/view/compare_wipe.h"
#include "app/gui/view/render_scheduler.h"
#include "app/gui/view/shown_scene.h"
#include "app/gui/view/sky_turn.h"
#include "app/gui/view/view_comparison.h"
#include "app/gui/view/viewport.h"
#include "app/gui/view/whole_view.h"
#include "app/gui/widgets/preferences.h"
#include "app/gui/window/exposure_tools.h"
#include "app/gui/window/key_list.h"
#include "app/gui/window/menu_bar.h"
#include "app/gui/window/panel_docks.h"
#include "app/gui/window/probe_clipboard.h"
#include "app/gui/window/status_line.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/scope_exit.h"
#include "filters/vtk/scene_renderer.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"

namespace boxprobe {

ViewTools::ViewTools(const Parts& parts, QMainWindow* window)
    : QObject(window),
      parts_(parts),
      views_(new ViewCommands(parts.editor, parts.state, parts.renderer, parts.viewport, parts.surfaces, this)),
      shown_(new ShownScene(
          {parts.editor, parts.state, parts.renderer, parts.surfaces,
           [this]() -> const ViewState::Names& { return parts_.panels.outliner().model().nodes(); }, parts.models},
          this)),
      pictureMenu_(new PictureMenu(
          {parts.editor, parts.state, parts.viewport, parts.handles, parts.surfaces, *views_, *shown_, parts.menu},
          window)),
      wipe_(new CompareWipe(&parts.viewport)),
      compare_(new PictureCompare(
          parts.document, *wipe_,
          {[this] { return parts_.scheduler.idle() && !parts_.renderer.workPending(); },
           [this] { return barePicture(); }, [this](const QSize& size) { return bareLight(size); },
           [this] { return parts_.renderer.currentCamera(); }, parts.models, [this] { return shownDiffuse(); }},
          this)),
      sideBySide_(
          new ViewComparison(parts.document, &parts.viewport,
                             {[this] { return parts_.scheduler.idle() && !parts_.renderer.workPending(); },
                              [this] { return barePicture(); }, [this](const QSize& size) { return bareLight(size); },
                              [this] { return parts_.renderer.currentCamera(); }, parts.models,
                              [this](const Scene& scene, const Changes& changes) {
                                parts_.renderer.sync(scene, changes);
                                parts_.scheduler.sceneChanged();
                              }},
                             this)),
      tags_(new FaceTags(
          parts.panels.fitPanel().gauge(), parts.editor,
          {[this] { return parts_.viewport.view(); },
           [this] { return parts_.shownHandles.GetVisibility() != 0 && parts_.handles.mode() == HandleMode::Box; }},
          &parts.viewport)),
      exposure_(new ExposureTools(parts.editor, parts.menu, window)) {
  connectViews();
  connectClicks(window);
  connectCompare();
  connectSideBySide();
  connectGauge();
  connectShown();
  connectOutliner();
  connect(&parts.editor, &Editor::selectionChanged, &parts.handles, &ProbeWidget::update);
  connect(exposure_, &ExposureTools::automaticWanted, this, &ViewTools::automaticExposureWanted);
}

void ViewTools::subscribe(ChangeViews& views) {
  views.add("exposure in the tool bar", {&Changes::exposure}, [this](const Changes&) { exposure_->update(); });
  views.add("shown scene",
            {&Changes::probeShape, &Changes::probeList, &Changes::selection, &Changes::objects, &Changes::models},
            [this](const Changes& changes) {
              if (changes.probeList || changes.models) {
                parts_.state.follow(parts_.editor.scene().probes, parts_.panels.outliner().model().nodes());
              }
              const bool others = changes.probeList || changes.selection || changes.objects || changes.models;
              if (others || parts_.state.cutaway()) shown_->update();
            });
}

// Cameras change the menu that asks for them: later.
void ViewTools::connectViews() {
  MenuBar* menu = &parts_.menu;
  connect(menu, &MenuBar::frameRequested, views_, &ViewCommands::frameSelection);
  connect(menu, &MenuBar::lookAlongChosen, views_, &ViewCommands::lookAlong);
  connect(menu, &MenuBar::lookFromProbeRequested, views_, &ViewCommands::lookFromProbe);
  connect(menu, &MenuBar::walkSwitched, views_, &ViewCommands::setWalking);
  connect(menu, &MenuBar::storeCameraRequested, pictureMenu_, &PictureMenu::storeCamera, Qt::QueuedConnection);
  connect(menu, &MenuBar::renameCameraRequested, pictureMenu_, &PictureMenu::renameCamera, Qt::QueuedConnection);
  connect(menu, &MenuBar::updateCameraRequested, views_, &ViewCommands::updateCamera, Qt::QueuedConnection);
  connect(menu, &MenuBar::deleteCameraRequested, views_, &ViewCommands::deleteCamera, Qt::QueuedConnection);
  auto* sky = new SkyTurn(parts_.editor, this);
  connect(menu, &MenuBar::skyLeftRequested, sky, [sky] { sky->turnBy(SkyTurn::kStep); });
  connect(menu, &MenuBar::skyRightRequested, sky, [sky] { sky->turnBy(-SkyTurn::kStep); });
  connect(&parts_.viewport, &Viewport::skyTurned, sky, &SkyTurn::drag);
  connect(&parts_.viewport, &Viewport::skyTurnEnded, sky, &SkyTurn::endDrag);
  connect(sky, &SkyTurn::message, &parts_.status, &StatusLine::showMessage);
  connect(views_, &ViewCommands::cameraMoved, &parts_.viewport, &Viewport::cameraMoved);
  auto* axes = new AxisGizmo([this] { return parts_.viewport.view(); }, &parts_.viewport);
  connect(axes, &AxisGizmo::chosen, views_, &ViewCommands::lookAlong);
  connect(&parts_.scheduler, &RenderScheduler::rendered, axes, QOverload<>::of(&QWidget::update));
  connect(menu, &MenuBar::keysSwitched, this, &ViewTools::showKeys);
  connect(menu, &MenuBar::countersSwitched, &parts_.status, &StatusLine::setCountersShown);
}

void ViewTools::connectShown() {
  MenuBar* menu = &parts_.menu;
  connect(menu, &MenuBar::hideRequested, shown_, &ShownScene::hideSelected);
  connect(menu, &MenuBar::showAllRequested, shown_, &ShownScene::showAll);
  connect(menu, &MenuBar::isolateRequested, shown_, &ShownScene::toggleIsolation);
  parts_.state.setCutaway(cutsAway());
  menu->showCutaway(parts_.state.cutaway());
  // From now on it is written to the preferences.
  connect(menu, &MenuBar::cutawaySwitched, shown_, &ShownScene::setCutaway);
  connect(shown_, &ShownScene::message, &parts_.status, &StatusLine::showMessage);
  connect(views_, &ViewCommands::message, &parts_.status, &StatusLine::showMessage);
  connect(shown_, &ShownScene::pictureChanged, &parts_.scheduler, &RenderScheduler::requestRender);
  connect(compare_, &PictureCompare::activeChanged, this, &ViewTools::showSceneWhole);
  connect(sideBySide_, &ViewComparison::onChanged, this, &ViewTools::showSceneWhole);
  // Whatever selects a probe.
  connect(&parts_.editor, &Editor::selectionChanged, &parts_.state, [this] { parts_.state.selectObjects({}); });
  connect(&parts_.handles, &ProbeWidget::taken, &parts_.panels.outliner(), &Outliner::showProbes);
}

void ViewTools::showSceneWhole() {
  shown_->setWhole(compare_->active() || sideBySide_->on());
}

void ViewTools::connectOutliner() {
  Outliner* outliner = &parts_.panels.outliner();
  PanelDocks* panels = &parts_.panels;
  connect(&parts_.menu, &MenuBar::selectAllRequested, outliner, &Outliner::selectAll);
  connect(outliner, &Outliner::frameRequested, views_, &ViewCommands::frameSelection);
  connect(outliner, &Outliner::isolateRequested, shown_, &ShownScene::toggleIsolation);
  connect(outliner, &Outliner::hideWanted, shown_, &ShownScene::setHidden);
  connect(outliner, &Outliner::aloneWanted, shown_, &ShownScene::isolate);
  connect(outliner, &Outliner::showAllRequested, shown_, &ShownScene::showAll);
  connect(outliner, &Outliner::objectChosen, panels, [panels](const QString& node) { panels->show(node, {}); });
  connect(outliner, &Outliner::lightChosen, &panels->lightPanel(), &LightPanel::choose);
  connect(outliner, &Outliner::cameraWanted, &parts_.menu, &MenuBar::cameraChosen);
  connect(outliner, &Outliner::cameraRenamed, views_, &ViewCommands::renameCamera);
  connect(outliner, &Outliner::message, &parts_.status, &StatusLine::showMessage);
  connect(outliner, &Outliner::cameraDeleted, views_, &ViewCommands::deleteCamera, Qt::QueuedConnection);
}

void ViewTools::connectClicks(QMainWindow* window) {
  connect(&parts_.viewport, &Viewport::selected, pictureMenu_, &PictureMenu::select);
  connect(&parts_.viewport, &Viewport::menuRequested, pictureMenu_, &PictureMenu::show);
  connect(&parts_.viewport, &Viewport::doubleClicked, pictureMenu_, &PictureMenu::selectProbeOf);
  connect(&parts_.menu, &MenuBar::selectHereRequested, pictureMenu_, &PictureMenu::selectHere);
  connect(pictureMenu_, &PictureMenu::picked, &parts_.panels, &PanelDocks::show);
  connect(pictureMenu_, &PictureMenu::shownInPanels, &parts_.panels, &PanelDocks::reveal);
  connect(pictureMenu_, &PictureMenu::message, &parts_.status, &StatusLine::showMessage);
  auto* clipboard = new ProbeClipboard(parts_.editor, window);
  connect(&parts_.menu, &MenuBar::copyRequested, clipboard, &ProbeClipboard::copy);
  connect(&parts_.menu, &MenuBar::pasteRequested, clipboard, &ProbeClipboard::paste);
  connect(clipboard, &ProbeClipboard::message, &parts_.status, &StatusLine::showMessage);
  connect(clipboard, &ProbeClipboard::failed, &parts_.status, &StatusLine::showError);
}

void ViewTools::connectCompare() {
  MenuBar* menu = &parts_.menu;
  connect(menu, &MenuBar::holdRequested, compare_, &PictureCompare::hold);
  connect(menu, &MenuBar::traceRequested, compare_, [this] { compare_->traceReference(TracedLight::All); });
  connect(menu, &MenuBar::traceReflectionRequested, compare_,
          [this] { compare_->traceReference(TracedLight::Reflection); });
  connect(menu, &MenuBar::traceErrorRequested, compare_, &PictureCompare::traceError);
  connect(menu, &MenuBar::differenceSwitched, compare_, &PictureCompare::setDifference);
  connect(compare_, &PictureCompare::differenceChanged, menu, &MenuBar::showDifference);
  connect(menu, &MenuBar::flipSwitched, compare_, &PictureCompare::setFlipped);
  connect(menu, &MenuBar::compareEnded, compare_, &PictureCompare::stop);
  connect(compare_, &PictureCompare::activeChanged, menu, &MenuBar::showCompare);
  connect(compare_, &PictureCompare::message, &parts_.status, &StatusLine::showMessage);
  connect(compare_, &PictureCompare::failed, &parts_.status, &StatusLine::showError);
  connect(&parts_.scheduler, &RenderScheduler::rendered, compare_, &PictureCompare::pictureDrawn);
  connect(&parts_.editor, &Editor::settled, compare_, &PictureCompare::documentChanged);
}

// One comparison at a time: both stand in the place of the picture.
void ViewTools::connectSideBySide() {
  MenuBar* menu = &parts_.menu;
  connect(menu, &MenuBar::viewsSwitched, sideBySide_, &ViewComparison::setOn);
  connect(sideBySide_, &ViewComparison::onChanged, menu, &MenuBar::showViews);
  connect(sideBySide_, &ViewComparison::onChanged, this, [this](bool on) {
    if (on) compare_->stop();
  });
  connect(compare_, &PictureCompare::activeChanged, this, [this](bool active) {
    if (active) sideBySide_->setOn(false);
  });
  connect(sideBySide_, &ViewComparison::message, &parts_.status, &StatusLine::showMessage);
  connect(sideBySide_, &ViewComparison::failed, &parts_.status, &StatusLine::showError);
  connect(&parts_.scheduler, &RenderScheduler::rendered, sideBySide_, &ViewComparison::pictureDrawn);
  connect(menu, &MenuBar::reflectionsShown, sideBySide_, &ViewComparison::pictureChanged);
  connect(parts_.debugView.surfacePanel(), &SurfaceViewPanel::changed, sideBySide_, &ViewComparison::pictureChanged);
  // Pixels are explained, and probes baked and saved, of the document's scene.
  connect(sideBySide_, &ViewComparison::ownSceneShown, &parts_.debugView,
          [this](bool own) { parts_.debugView.setPaused(!own); });
  connect(&parts_.debugView, &DebugView::toolChanged, this, [this](bool on) {
    if (on) showOwnScene();
  });
  connect(&parts_.panels.bakePanel(), &BakePanel::ownSceneWanted, this, &ViewTools::showOwnScene);
}

void ViewTools::showOwnScene() {
  sideBySide_->setOn(false);
}

bool ViewTools::stopComparing() {
  const bool any = compare_->active() || sideBySide_->on();
  compare_->stop();
  sideBySide_->setOn(false);
  return any;
}

void ViewTools::connectGauge() {
  GaugeRows* rows = &parts_.panels.fitPanel().rows();
  connect(&parts_.scheduler, &RenderScheduler::rendered, tags_, &FaceTags::follow);
  connect(rows, &GaugeRows::spotWanted, this, [this](const WorstSpot& spot) {
    views_->lookAtSpot(spot.positionWorld, spot.eyeWorld);
    tags_->showSpot(spot);
  });
  connect(rows, &GaugeRows::comeBackWanted, this, [this] {
    views_->comeBack();
    tags_->showSpot({});
  });
  connect(views_, &ViewCommands::canComeBack, rows, &GaugeRows::setCanComeBack);
}

void ViewTools::modelsReplaced() {
  sideBySide_->forget();
  parts_.editor.selectAlone();
  views_->forgetView();
  tags_->showSpot({});
}

ProbesDiffuse ViewTools::shownDiffuse() const {
  return parts_.renderer.probesDiffuse();
}

QImage ViewTools::barePicture() {
  if (!parts_.viewport.readyToDraw()) return {};
  parts_.viewport.window3d()->MakeCurrent();
  ImageRgba8 image;
  try {
    const int shown = parts_.shownHandles.GetVisibility();
    parts_.shownHandles.VisibilityOff();
    const ScopeExit again([this, shown] { parts_.shownHandles.SetVisibility(shown); });
    const WholeView whole(parts_.renderer);
    image = parts_.renderer.renderDisplay();
  } catch (const Error& error) {
    parts_.status.showError(QString::fromUtf8(error.what()));
    return {};
  }
  parts_.viewport.window3d()->Render();  // the handles again
  const QImage shared(image.pixels.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888);
  return shared.convertToFormat(QImage::Format_RGB32);
}

ImageRgbaF ViewTools::bareLight(const QSize& size) {
  if (!parts_.viewport.readyToDraw()) return {};
  try {
    return parts_.renderer.renderLinear(size.width(), size.height(), 1);
  } catch (const Error& error) {
    parts_.status.showError(QString::fromUtf8(error.what()));
    return {};
  }
}

void ViewTools::showKeys(bool shown) {
  if (keys_ == nullptr) {
    keys_ = new QLabel(keyTable(), &parts_.viewport);
    keys_->setObjectName("keys");
    keys_->setAttribute(Qt::WA_TransparentForMouseEvents);
    keys_->setStyleSheet("QLabel { color: #f4f4f4; background: rgba(16, 18, 22, 225); padding: 10px 14px; }");
    keys_->setWordWrap(true);
  }
  constexpr int kMargin = 8, kWidest = 760;
  keys_->setFixedWidth(std::min(kWidest, parts_.viewport.width() - 2 * kMargin));
  keys_->adjustSize();
  keys_->move(kMargin, kMargin);
  keys_->raise();
  keys_->setVisible(shown);
}

}  // namespace boxprobe
