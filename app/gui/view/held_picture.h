// Keeps the last picture on the screen while another is made: a step of a lesson is turned to like a page, without a
// half-captured room in between. Called by the lesson view; knows the renderer only as a function.
#pragma once

#include <QObject>

class QLabel;

namespace boxprobe {

class Viewport;

class HeldPicture : public QObject {
  Q_OBJECT

 public:
  explicit HeldPicture(Viewport& viewport, QObject* parent = nullptr);

  /// What is on the screen now stays there. Does nothing before the first picture.
  void hold();
  void release();
  bool held() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  Viewport& viewport_;
  QLabel* picture_;
  QLabel* note_;
};

}  // namespace boxprobe
