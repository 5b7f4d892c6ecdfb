// Keeps a small picture of a scene that was opened or saved, once its picture rests. Called by the main window.
#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>

namespace boxprobe {

class ThumbnailKeeper : public QObject {
  Q_OBJECT

 public:
  struct Hooks {
    std::function<QString()> path;    ///< of the user's own scene; empty: none, or something else is on show
    std::function<bool()> atRest;     ///< the plain picture is on show, nothing is left to capture, nobody drags
    std::function<QImage()> picture;  ///< as it is on the screen, handles included
  };
  explicit ThumbnailKeeper(Hooks hooks, QObject* parent = nullptr);

  /// The scene on show was opened or saved.
  void opened();

 private:
  void look();

  Hooks hooks_;
  QTimer later_;
  QString due_;
  int looks_ = 0;  ///< since then; a realtime probe never rests
};

}  // namespace boxprobe
