// Four pictures of one view in place of the picture in the window: what each shows is chosen below it, and its error
// stands beside. Called by the comparison; knows images, names and lines of text, no scene.
#pragma once

#include <QComboBox>
#include <QFont>
#include <QImage>
#include <QString>
#include <QWidget>
#include <array>
#include <vector>

namespace boxprobe {

class CompareViews : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kViews = 4;
  struct Choice {
    QString id, text, toolTip;
  };

  CompareViews(QWidget* picture, const std::vector<Choice>& choices);

  void choose(int view, const QString& id);
  QString chosen(int view) const;
  /// A null image: the note alone.
  void show(int view, const QImage& picture, const QString& note);
  /// Under the picture, one line or two; empty: nothing.
  void showNumbers(int view, const QString& text);
  QString numbers(int view) const { return cells_[static_cast<std::size_t>(view)].numbers; }
  /// All of it, without forgetting anything.
  void setShown(bool shown);

 signals:
  /// By the user.
  void chosenAnew(int view);

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Cell {
    QComboBox* choice = nullptr;
    QImage picture;
    QString note, numbers;
  };
  QRect place(int view) const;                          ///< of the picture and the line under it
  QFont fontFor(const QString& text, int width) const;  ///< smaller where the text is wider
  bool narrow() const;
  int strip() const;  ///< height of the line under each picture
  void arrange();

  std::array<Cell, kViews> cells_;
};

}  // namespace boxprobe
