// File > Report: the scene on show, reviewed as `boxprobe report` does. Asks for the file, works beside the window,
// tells of the end.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "app/session/load_scene.h"
#include "app/session/scene_review.h"

namespace boxprobe {

class Workspace;

class SceneReporter : public QObject {
  Q_OBJECT

 public:
  SceneReporter(Workspace& workspace, QWidget* window);

  /// Asks where to, and writes.
  void ask();
  /// Writes the report to `path`. False if it was cancelled or failed, which is told.
  bool write(const QString& path);
  /// Of the pictures; tests make them small.
  void setSettings(const ReviewSettings& settings) { settings_ = settings; }

 signals:
  void message(const QString& text);
  void failed(const QString& text);

 private:
  Workspace& workspace_;
  QWidget* window_;
  ReviewSettings settings_;
};

}  // namespace boxprobe
