// See picture_panel.h.
#include "app/gui/panels/picture_panel.h"

#include <QFormLayout>
#include <QVBoxLayout>

#include "app/gui/edit/exposure_control.h"
#include "app/gui/widgets/panel_layout.h"

namespace boxprobe {

PicturePanel::PicturePanel(Editor& editor, QWidget* parent)
    : QWidget(parent), exposure_(new ExposureControl(editor, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Picture"));
  addRow(form, tr("Exposure"), exposure_, ExposureControl::toolTipText());
}

void PicturePanel::update() {
  exposure_->update();
}

}  // namespace boxprobe
