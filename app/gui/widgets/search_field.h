// A field to find by words in.
#pragma once

#include <QKeyEvent>
#include <QLineEdit>

namespace boxprobe {

/// Esc empties it before it is anything else's.
class SearchField : public QLineEdit {
 public:
  using QLineEdit::QLineEdit;

 protected:
  bool event(QEvent* event) override {
    const bool key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (!key || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape || text().isEmpty()) {
      return QLineEdit::event(event);
    }
    event->accept();
    if (event->type() == QEvent::KeyPress) clear();
    return true;
  }
};

}  // namespace boxprobe
