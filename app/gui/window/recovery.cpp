// See recovery.h.
#include "app/gui/window/recovery.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPushButton>

#include "app/gui/widgets/message_box.h"
#include "app/gui/window/autosave.h"
#include "app/gui/window/file_commands.h"
#include "app/gui/window/main_window.h"

namespace boxprobe {

void offerRecovery(MainWindow& window) {
  for (const Autosave::Kept& kept : Autosave::leftBehind()) {
    const QString time = QLocale::system().toString(kept.time, QLocale::ShortFormat);
    const QString scene = kept.folderShown.isEmpty()
                              ? kept.name
                              : QCoreApplication::translate("Recovery", "%1 in %2").arg(kept.name, kept.folderShown);
    PlainQuestion box(&window, QCoreApplication::translate("Recovery", "Unsaved changes"),
                      QCoreApplication::translate(
                          "Recovery", "Boxprobe ended without saving %1. Its changes up to %2 can be recovered.")
                          .arg(scene, time));
    box.setInformativeText(
        QCoreApplication::translate("Recovery", "Nothing is written to the file itself until you save."));
    const QPushButton* recover =
        box.addButton(QCoreApplication::translate("Recovery", "&Recover"), QMessageBox::AcceptRole);
    const QPushButton* discard =
        box.addButton(QCoreApplication::translate("Recovery", "&Discard them"), QMessageBox::DestructiveRole);
    QPushButton* later = box.addButton(QCoreApplication::translate("Recovery", "Ask &later"), QMessageBox::RejectRole);
    box.setEscapeButton(later);
    box.exec();
    if (box.clickedButton() == discard) Autosave::discard(kept);
    if (box.clickedButton() != recover) continue;
    if (!window.files().recover(kept)) return;               // it stays for the next start
    if (window.autosave().write()) Autosave::discard(kept);  // from here on this process keeps them
    return;
  }
}

bool offerRestart(MainWindow& window) {
  const bool kept = window.autosave().write();
  PlainQuestion box(
      &window, QCoreApplication::translate("Recovery", "No picture"),
      QCoreApplication::translate("Recovery", "The graphics driver was reset. Start Boxprobe again to see the scene."));
  box.setInformativeText(
      kept ? QCoreApplication::translate("Recovery", "Unsaved changes are kept and offered after the start.")
           : QCoreApplication::translate("Recovery", "Unsaved changes could not be kept. Save the scene first."));
  QPushButton* again = box.addButton(QCoreApplication::translate("Recovery", "&Start again"), QMessageBox::AcceptRole);
  QPushButton* stay = box.addButton(QCoreApplication::translate("Recovery", "&Not now"), QMessageBox::RejectRole);
  box.setDefaultButton(kept ? again : stay);
  box.setEscapeButton(stay);
  box.exec();
  if (box.clickedButton() != again) return false;
  window.autosave().keep();
  return true;
}

}  // namespace boxprobe
