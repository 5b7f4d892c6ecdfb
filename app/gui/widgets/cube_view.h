// A cubemap's level as a picture to look at and point into. Called by the probe preview; knows no probe.
#pragma once

#include <QImage>
#include <QWidget>
#include <glm/vec3.hpp>
#include <optional>

#include "filters/core/picture/cube_picture.h"

namespace boxprobe {

class CubeFaces : public QWidget {
  Q_OBJECT

 public:
  explicit CubeFaces(QWidget* parent = nullptr);

  /// Draws `cube` (its level 0; empty: `instead`) at the width the widget has.
  void show(const CubeMap* cube, CubePictureKind kind, float exposure, const QString& instead);
  const QImage& image() const { return image_; }

  QSize sizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 signals:
  /// The direction under the pointer; nothing outside the cube.
  void pointed(const std::optional<glm::vec3>& direction);
  void widthChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  CubePictureKind kind_ = CubePictureKind::Cross;
  QImage image_;
  QString instead_;
};

}  // namespace boxprobe
