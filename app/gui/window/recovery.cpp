// See recovery.h.
#include "app/gui/window/recovery.h"

#include <QCoreApplication>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include "app/gui/window/autosave.h"
#include "app/gui/window/file_commands.h"
#include "app/gui/window/main_window.h"

namespace boxprobe {

namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("Recovery", text);
}

}  // namespace

void offerRecovery(MainWindow& window) {
  for (const Autosave::Kept& kept : Autosave::leftBehind()) {
    const QString time = QLocale().toString(kept.time, QLocale::ShortFormat);
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("Boxprobe ended without saving %1. Its changes up to %2 can be recovered.").arg(kept.name, time),
                    QMessageBox::NoButton, &window);
    box.setInformativeText(tr("Nothing is written to the file itself until you save."));
    const QPushButton* recover = box.addButton(tr("&Recover"), QMessageBox::AcceptRole);
    const QPushButton* discard = box.addButton(tr("&Discard them"), QMessageBox::DestructiveRole);
    QPushButton* later = box.addButton(tr("Ask &later"), QMessageBox::RejectRole);
    box.setEscapeButton(later);
    box.exec();
    if (box.clickedButton() == discard) Autosave::discard(kept);
    if (box.clickedButton() != recover) continue;
    if (!window.files().recover(kept.scene, kept.original, kept.time)) return;  // it stays for the next start
    if (window.autosave().write()) Autosave::discard(kept);                     // from here on this process keeps them
    return;
  }
}

}  // namespace boxprobe
