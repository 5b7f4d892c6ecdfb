// See exposure_tools.h.
#include "app/gui/window/exposure_tools.h"

#include <QColorDialog>
#include <QLabel>
#include <QMainWindow>
#include <QSignalBlocker>
#include <QToolBar>
#include <QToolButton>
#include <utility>

#include "app/gui/edit/exposure_control.h"
#include "app/gui/view/workspace.h"
#include "filters/math/shared/display_math.h"

namespace boxprobe {

namespace {

constexpr double kStep = 1.0 / 3.0;  ///< stops a key press, as on a camera
constexpr int kControlWidth = 230;

}  // namespace

ExposureTools::ExposureTools(Workspace& workspace, QMainWindow* window)
    : QObject(window), workspace_(workspace), control_(new ExposureControl(workspace.editor())) {
  auto* bar = window->findChild<QToolBar*>("tools");
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  auto* label = new QLabel(tr("Exposure"), bar);
  label->setToolTip(ExposureControl::toolTipText());
  label->setContentsMargins(0, 0, 6, 0);
  bar->addWidget(label);
  control_->setObjectName("exposureInBar");
  control_->setFixedWidth(kControlWidth);
  bar->addWidget(control_);
  auto* automatic = new QToolButton(bar);
  automatic->setObjectName("exposeAutomatically");
  automatic->setText(tr("Auto"));
  automatic->setToolTip(tr("Sets the exposure that suits the picture as it is now; Undo takes it back"));
  bar->addWidget(automatic);
  connect(automatic, &QToolButton::clicked, workspace.actions().expose, &QAction::trigger);
  observe(window);
}

void ExposureTools::observe(QWidget* window) {
  const Actions& actions = workspace_.actions();
  Editor* editor = &workspace_.editor();
  connect(actions.brighter, &QAction::triggered, control_, [this] { control_->step(kStep); });
  connect(actions.darker, &QAction::triggered, control_, [this] { control_->step(-kStep); });
  connect(actions.tones, &QActionGroup::triggered, editor, [editor](const QAction* tone) {
    editor->commit(tr("Set tone mapping"),
                   [tone](Scene& scene) { scene.tone = static_cast<Tone>(tone->data().toInt()); });
  });
  connect(actions.backgrounds, &QActionGroup::triggered, this,
          [this, window](const QAction* chosen) { setBackground(chosen->data().toInt(), window); });
  connect(actions.groundShadow, &QAction::toggled, editor, [editor](bool on) {
    editor->commit(tr("Switch ground shadow"), [on](Scene& scene) { scene.groundShadow = on; });
  });
  connect(actions.ambientOcclusion, &QAction::toggled, editor, [editor](bool on) {
    editor->commit(tr("Switch ambient occlusion"), [on](Scene& scene) { scene.ambientOcclusion = on; });
  });
  workspace_.changes().add("exposure in the tool bar", {&Changes::exposure}, [this](const Changes&) { update(); });
}

void ExposureTools::update() {
  control_->update();
  const Actions& actions = workspace_.actions();
  const Scene& scene = workspace_.editor().scene();
  showChoice(actions.tones, static_cast<int>(scene.tone));
  showChoice(actions.backgrounds, static_cast<int>(scene.background));
  // Without telling anybody: it is the document that they follow.
  for (const auto& [action, on] : {std::pair(actions.groundShadow, scene.groundShadow),
                                   std::pair(actions.ambientOcclusion, scene.ambientOcclusion)}) {
    const QSignalBlocker quiet(action);
    action->setChecked(on);
  }
}

void ExposureTools::setBackground(int chosen, QWidget* over) {
  const auto background = static_cast<Background>(chosen);
  glm::vec3 color = workspace_.editor().scene().backgroundColor;
  if (background == Background::Color) {
    const auto bytes = displayBytes(color, 1.0);
    const QColor picked = QColorDialog::getColor(QColor(bytes[0], bytes[1], bytes[2]), over, tr("Background"));
    if (!picked.isValid()) return update();
    color = shading::srgbDecoded(glm::vec3(static_cast<float>(picked.redF()), static_cast<float>(picked.greenF()),
                                           static_cast<float>(picked.blueF())));
  }
  workspace_.editor().commit(tr("Set background"), [&](Scene& scene) {
    scene.background = background;
    scene.backgroundColor = color;
  });
}

}  // namespace boxprobe
