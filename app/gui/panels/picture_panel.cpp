// See picture_panel.h.
#include "app/gui/panels/picture_panel.h"

#include <QFormLayout>
#include <QVBoxLayout>

#include "app/gui/edit/exposure_control.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/panel_layout.h"

namespace boxprobe {

PicturePanel::PicturePanel(Workspace& workspace) {
  auto* exposure = new ExposureControl(workspace.editor(), this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  QFormLayout* form = addSection(this, tr("Picture"));
  addRow(form, tr("Exposure"), exposure, ExposureControl::toolTipText());
  workspace.changes().add("picture panel", {&Changes::exposure}, [exposure](const Changes&) { exposure->update(); });
}

}  // namespace boxprobe
