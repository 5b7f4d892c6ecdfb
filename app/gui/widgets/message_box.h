// Message boxes. Their text holds names of files and probes, which may look like HTML: all of it is plain text.
#pragma once

#include <QMessageBox>
#include <QString>

class QWidget;

namespace boxprobe {

/// Waits for the answer. Closed without one it is Cancel or No, whichever is among `buttons`.
QMessageBox::StandardButton askUser(QWidget* parent, const QString& title, const QString& question,
                                    QMessageBox::StandardButtons buttons = QMessageBox::Yes | QMessageBox::No,
                                    QMessageBox::StandardButton standard = QMessageBox::NoButton);

/// Asks where a file of that name exists. For names that were completed after a file dialog, which asked about the name
/// as it was typed.
bool mayOverwrite(QWidget* parent, const QString& title, const QString& path);

/// What could not be done, and why.
void warnUser(QWidget* parent, const QString& title, const QString& line);

/// For a box with buttons of its own: a question with the text as it is.
class PlainQuestion : public QMessageBox {
 public:
  PlainQuestion(QWidget* parent, const QString& title, const QString& question,
                QMessageBox::StandardButtons buttons = QMessageBox::NoButton);
};

/// A tool tip that shows `text` as it is, and not as HTML where it looks like that.
QString plainToolTip(const QString& text);

}  // namespace boxprobe
