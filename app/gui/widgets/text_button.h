// A button of running text: a heading, lines below it that wrap, and a mark at its left. Lessons in the list and
// answers of a question are such buttons. Called by the lesson's pages. Not a QCommandLinkButton: its heading never
// wraps (a lesson's title makes it 637 pixels wide), its text is cut in a narrow dock, and an answer, which has no
// heading, keeps an empty line for one (Qt 5.15).
#pragma once

#include <QAbstractButton>
#include <QString>

class QPainter;

namespace boxprobe {

class TextButton : public QAbstractButton {
  Q_OBJECT

 public:
  enum class Mark { None, Empty, Begun, Right, Wrong };

  explicit TextButton(QWidget* parent = nullptr);

  /// `heading` is bold; either may be empty. `corner` stands at the heading's right, dim.
  void show(const QString& heading, const QString& body, const QString& corner = {});
  void setMark(Mark mark);
  Mark mark() const { return mark_; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Layout;
  Layout layOut(int width) const;
  void paintMark(QPainter& painter, const QRectF& square) const;

  QString heading_, body_, corner_;
  Mark mark_ = Mark::None;
};

}  // namespace boxprobe
