// See about_dialog.h.
#include "app/gui/window/about_dialog.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QObject>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/widgets/window_language.h"
#include "app/gui/window/key_list.h"

namespace boxprobe {

namespace {

constexpr int kWidth = 760, kHeight = 600;

/// Of a language other than English.
QString unreviewed() {
  if (shownLanguage() == "en") return {};
  return "<p>" + QObject::tr("This translation has not been reviewed by a native speaker yet.") + "</p>";
}

}  // namespace

QDialog* aboutDialog(QWidget* parent) {
  const QString text =
      QObject::tr(
          "<h3>Boxprobe %1</h3><p>Reflection probes with box projection (parallax correction): move the box and the "
          "capture origin and watch the reflections follow.</p>")
          .arg(BOXPROBE_VERSION) +
      keyTable() + "<p>" +
      QObject::tr(
          "Orange: the projection box. Dashed: the probe has its full weight inside. Built on VTK, Qt, OpenEXR and "
          "GLM.") +
      "</p>" + unreviewed();
  auto* dialog = new QDialog(parent);
  dialog->setObjectName("about");
  dialog->setWindowTitle(QObject::tr("About Boxprobe"));
  auto* rows = new QVBoxLayout(dialog);
  auto* page = new QTextBrowser(dialog);
  page->setAccessibleName(QObject::tr("Mouse and keys"));
  page->setHtml(text);
  rows->addWidget(page, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok, dialog);
  QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
  rows->addWidget(buttons);
  buttons->button(QDialogButtonBox::Ok)->setFocus();
  QSize size(kWidth, kHeight);
  if (const QScreen* screen = parent != nullptr ? parent->window()->screen() : nullptr) {
    constexpr double kOfScreen = 0.85;  // frames take a share
    size = size.boundedTo(kOfScreen * screen->availableSize());
  }
  dialog->resize(size);
  return dialog;
}

void showAbout(QWidget* parent) {
  const QPointer<QDialog> dialog = aboutDialog(parent);
  dialog->exec();
  delete dialog;
}

}  // namespace boxprobe
