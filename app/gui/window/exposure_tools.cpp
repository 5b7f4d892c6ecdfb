// See exposure_tools.h.
#include "app/gui/window/exposure_tools.h"

#include <QLabel>
#include <QMainWindow>
#include <QToolBar>
#include <QToolButton>

#include "app/gui/edit/exposure_control.h"
#include "app/gui/window/menu_bar.h"

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
  connect(&menu, &MenuBar::brighterRequested, control_, [this] { control_->step(kStep); });
  connect(&menu, &MenuBar::darkerRequested, control_, [this] { control_->step(-kStep); });
}

void ExposureTools::update() {
  control_->update();
  menu_.showTone(static_cast<int>(editor_.scene().tone));
}

}  // namespace boxprobe
