// See message_box.h.
#include "app/gui/widgets/message_box.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QTextDocument>

namespace boxprobe {

PlainQuestion::PlainQuestion(QWidget* parent, const QString& title, const QString& question,
                             QMessageBox::StandardButtons buttons)
    : QMessageBox(QMessageBox::Question, title, {}, buttons, parent) {
  setTextFormat(Qt::PlainText);
  setText(question);
}

QMessageBox::StandardButton askUser(QWidget* parent, const QString& title, const QString& question,
                                    QMessageBox::StandardButtons buttons, QMessageBox::StandardButton standard) {
  PlainQuestion box(parent, title, question, buttons);
  if (standard != QMessageBox::NoButton) box.setDefaultButton(standard);
  return static_cast<QMessageBox::StandardButton>(box.exec());
}

bool mayOverwrite(QWidget* parent, const QString& title, const QString& path) {
  if (!QFileInfo::exists(path)) return true;
  const QString question = QCoreApplication::translate("boxprobe", "%1 already exists. Replace it?").arg(path);
  return askUser(parent, title, question) == QMessageBox::Yes;
}

void warnUser(QWidget* parent, const QString& title, const QString& line) {
  QMessageBox box(QMessageBox::Warning, title, {}, QMessageBox::Ok, parent);
  box.setTextFormat(Qt::PlainText);
  box.setText(line);
  box.exec();
}

QString plainToolTip(const QString& text) {
  return Qt::mightBeRichText(text) ? "<span>" + text.toHtmlEscaped() + "</span>" : text;
}

}  // namespace boxprobe
