// A scene to choose: its picture, its name and a line about it.
#pragma once

#include <QImage>
#include <QPushButton>
#include <QString>

namespace boxprobe {

class SceneCard : public QPushButton {
  Q_OBJECT

 public:
  SceneCard(const QString& title, const QString& words, QWidget* parent = nullptr);

  /// Null: an icon in its place.
  void setPicture(const QImage& picture);
  bool hasPicture() const { return !picture_.isNull(); }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString title_, words_;
  QImage picture_;
};

}  // namespace boxprobe
