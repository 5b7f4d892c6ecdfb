// A titled group of a panel that folds when its title is clicked, stays folded in later runs, and can be found by a
// word.
#pragma once

#include <QGroupBox>
#include <QString>

namespace boxprobe {

class PanelSection : public QGroupBox {
  Q_OBJECT

 public:
  PanelSection(const QString& title, QWidget* parent);

  bool folded() const { return folded_; }
  /// As the user does by a click on the title.
  void setFolded(bool folded);

  /// Shown whole if its title or the text of something in it has `words`, else hidden; empty: as it was.
  /// Returns whether it has them.
  bool showIfFound(const QString& words);

  void setVisible(bool visible) override;

 protected:
  void mousePressEvent(QMouseEvent* event) override;

 private:
  bool has(const QString& words) const;
  void follow();

  QString title_;
  bool folded_ = false;
  bool wanted_ = true;  ///< what the panel asked for, whatever is looked for
  bool searching_ = false, found_ = true;
};

/// A field above `content`, by which the sections in it are found. Returns the two in one widget; the sections show
/// what is typed at once, and Esc empties it.
QWidget* withSearch(QWidget* content, const QString& hint);

}  // namespace boxprobe
