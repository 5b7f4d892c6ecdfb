// Keeps a small picture of a scene that was opened or saved, once its picture rests.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

namespace boxprobe {

class Workspace;

class ThumbnailKeeper : public QObject {
  Q_OBJECT

 public:
  ThumbnailKeeper(Workspace& workspace, QObject* parent);

 private:
  /// The scene on show was opened or saved.
  void opened();
  /// Of the user's own scene; empty: none, or a lesson's is on show.
  QString path() const;
  /// The plain picture is on show, nothing is left to capture, nobody drags.
  bool rests() const;
  void look();

  Workspace& workspace_;
  QTimer later_;
  QString due_;
  int looks_ = 0;  ///< since then; a realtime probe never rests
};

}  // namespace boxprobe
