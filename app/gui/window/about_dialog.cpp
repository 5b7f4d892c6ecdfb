// See about_dialog.h.
#include "app/gui/window/about_dialog.h"

#include <QMessageBox>
#include <QObject>

#include "app/gui/window/key_list.h"

namespace boxprobe {

void showAbout(QWidget* parent) {
  const QString text =
      QObject::tr(
          "<h3>Boxprobe %1</h3><p>Reflection probes with box projection (parallax correction): move the box and the "
          "capture origin and watch the reflections follow.</p>")
          .arg(BOXPROBE_VERSION) +
      keyTable() + "<p>" +
      QObject::tr(
          "Orange: the projection box. Dashed: the probe has its full weight inside. Built on VTK, Qt, OpenEXR and "
          "GLM.") +
      "</p>";
  QMessageBox box(parent);
  box.setWindowTitle(QObject::tr("About Boxprobe"));
  box.setTextFormat(Qt::RichText);
  box.setText(text);
  box.exec();
}

}  // namespace boxprobe
