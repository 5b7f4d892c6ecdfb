// See about_dialog.h.
#include "app/gui/window/about_dialog.h"

#include <QMessageBox>
#include <QObject>

namespace boxprobe {

namespace {

QString row(const QString& what, const QString& does) {
  return QString("<tr><td style='padding-right:18px'><b>%1</b></td><td>%2</td></tr>").arg(what, does);
}

}  // namespace

void showAbout(QWidget* parent) {
  const QString text =
      QObject::tr(
          "<h3>Boxprobe %1</h3><p>Reflection probes with box projection (parallax correction): move the box and the "
          "capture origin and watch the reflections follow.</p>")
          .arg(BOXPROBE_VERSION) +
      "<table>" + row(QObject::tr("Drag a ball"), QObject::tr("moves that face of the box; Ctrl moves both sides")) +
      row(QObject::tr("Drag the diamond"), QObject::tr("moves the capture origin, parallel to the screen")) +
      row(QObject::tr("Shift, or X, Y, Z held"), QObject::tr("moves the origin up and down, or along that axis")) +
      row(QObject::tr("Esc"), QObject::tr("cancels the drag or stops capturing")) +
      row(QObject::tr("Click a white diamond"), QObject::tr("selects that probe")) +
      row(QObject::tr("Drag elsewhere"), QObject::tr("turns the view; Shift or the middle button moves it")) +
      row(QObject::tr("Wheel, right button"), QObject::tr("zooms")) +
      row(QObject::tr("Drag X, Y, Z labels"), QObject::tr("changes the number beside them; Shift for fine steps")) +
      row(QObject::tr("Ctrl+Z, Ctrl+Shift+Z"), QObject::tr("undo, redo")) +
      row(QObject::tr("Ctrl+1 ... 9, Home"), QObject::tr("the scene's cameras, reset view")) +
      row(QObject::tr("Ctrl+B, Ctrl+R"), QObject::tr("show or hide boxes, reflections")) +
      row(QObject::tr("F1, F11"), QObject::tr("the lessons; projector mode with the picture and the lesson alone")) +
      row(QObject::tr("Right, Left, Page Down, Page Up"), QObject::tr("next and last step of a lesson")) +
      row(QObject::tr("Ctrl+F"), QObject::tr("fits the selected probe's box; again: stops")) +
      row(QObject::tr("F5, Shift+F5"), QObject::tr("recaptures the selected probe, all probes")) + "</table><p>" +
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
