// A formula in a panel: as large as its letters ask for, smaller where the panel is too narrow for it. Called by the
// lesson's step page.
#pragma once

#include <QWidget>

#include "app/gui/formula/math_box.h"

namespace boxprobe {

class FormulaLabel : public QWidget {
  Q_OBJECT

 public:
  explicit FormulaLabel(QWidget* parent = nullptr);

  /// An empty one hides the widget. `plainText` is what a screen reader says.
  void setMathml(const QString& mathml, const QString& plainText);

  QSize sizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  double em(int width) const;  ///< pixels

  MathBox box_;
  QRectF ink_;
};

}  // namespace boxprobe
