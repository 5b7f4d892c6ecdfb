// Another picture over the one in the window, to the right of a divider that is dragged. Called by the comparison;
// knows two names, a line of numbers and an image, no scene.
#pragma once

#include <QImage>
#include <QWidget>

class QLabel;
class QPainter;

namespace boxprobe {

class CompareWipe : public QWidget {
  Q_OBJECT

 public:
  explicit CompareWipe(QWidget* picture);

  void show(const QImage& other, const QString& name);
  void showNumbers(const QString& text);
  /// The bar of differenceColor() with its ends.
  void setScaleShown(bool shown);
  /// The other picture alone, or as the divider says.
  void setFlipped(bool flipped);
  bool flipped() const { return flipped_; }
  /// Where the divider stands, 0 left to 1 right.
  double divider() const { return divider_; }
  void setDivider(double share);
  /// Both, without forgetting either.
  void setShown(bool shown);

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  void paintScale(QPainter& painter) const;

  QImage other_;
  QWidget* bar_;
  QLabel *left_, *right_, *numbers_;
  double divider_ = 0.5;
  bool flipped_ = false, scale_ = false;
};

}  // namespace boxprobe
