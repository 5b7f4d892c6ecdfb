// See exposure_tools.h.
#include "app/gui/window/exposure_tools.h"

#include <QColorDialog>
#include <QLabel>
#include <QMainWindow>
#include <QToolBar>
#include <QToolButton>

#include "app/gui/edit/exposure_control.h"
#include "app/gui/window/menu_bar.h"
#include "filters/math/shared/display_math.h"

namespace boxprobe {

namespace {

constexpr double kStep = 1.0 / 3.0;  ///< stops a key press, as on a camera
constexpr int kControlWidth = 230;

}  // namespace

ExposureTools::ExposureTools(Editor& editor, MenuBar& menu, QMainWindow* window)
    : QObject(window), editor_(editor), menu_(menu), control_(new ExposureControl(editor)) {
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
  connect(automatic, &QToolButton::clicked, this, &ExposureTools::automaticWanted);
  connect(&menu, &MenuBar::exposeRequested, this, &ExposureTools::automaticWanted);
  connect(&menu, &MenuBar::toneChosen, this, [this](int tone) {
    editor_.commit(tr("Set tone mapping"), [tone](Scene& scene) { scene.tone = static_cast<Tone>(tone); });
  });
  connect(&menu, &MenuBar::backgroundChosen, this, [this, window](int chosen) { setBackground(chosen, window); });
  connect(&menu, &MenuBar::groundShadowSwitched, this, [this](bool on) {
    editor_.commit(tr("Switch ground shadow"), [on](Scene& scene) { scene.groundShadow = on; });
  });
  connect(&menu, &MenuBar::ambientOcclusionSwitched, this, [this](bool on) {
    editor_.commit(tr("Switch ambient occlusion"), [on](Scene& scene) { scene.ambientOcclusion = on; });
  });
  connect(&menu, &MenuBar::brighterRequested, control_, [this] { control_->step(kStep); });
  connect(&menu, &MenuBar::darkerRequested, control_, [this] { control_->step(-kStep); });
}

void ExposureTools::update() {
  control_->update();
  const Scene& scene = editor_.scene();
  menu_.showTone(static_cast<int>(scene.tone));
  menu_.showSurroundings(static_cast<int>(scene.background), scene.groundShadow, scene.ambientOcclusion);
}

void ExposureTools::setBackground(int chosen, QWidget* over) {
  const auto background = static_cast<Background>(chosen);
  glm::vec3 color = editor_.scene().backgroundColor;
  if (background == Background::Color) {
    const auto bytes = displayBytes(color, 1.0);
    const QColor picked = QColorDialog::getColor(QColor(bytes[0], bytes[1], bytes[2]), over, tr("Background"));
    if (!picked.isValid()) return update();
    color = shading::srgbDecoded(glm::vec3(static_cast<float>(picked.redF()), static_cast<float>(picked.greenF()),
                                           static_cast<float>(picked.blueF())));
  }
  editor_.commit(tr("Set background"), [&](Scene& scene) {
    scene.background = background;
    scene.backgroundColor = color;
  });
}

}  // namespace boxprobe
