// Answers the modal dialogs a command opens, as a user would: the answer waits in the event loop for the dialog to
// appear.
#pragma once

#include <QMessageBox>
#include <QString>
#include <memory>

namespace boxprobe {

/// What was seen; `text` stays empty if no dialog came.
struct SeenDialog {
  QString text;
  bool plain = false;  ///< of a message box: no part of the text is taken for HTML
};

/// For the next message box: presses `button`.
std::shared_ptr<SeenDialog> answerMessageBox(QMessageBox::StandardButton button);

/// The same for the button whose text begins so, without its mnemonic.
std::shared_ptr<SeenDialog> answerMessageBox(const QString& button);

/// For the next dialog that asks for a text or for one of several: types `text`, or chooses it, and accepts; rejects it
/// if there is none.
std::shared_ptr<SeenDialog> answerInputDialog(const QString& text);

/// For the next file dialog: types `path` and accepts.
std::shared_ptr<SeenDialog> answerFileDialog(const QString& path);

}  // namespace boxprobe
