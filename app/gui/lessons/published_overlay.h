// Over the picture, the same as a published form of the projection has it: drawn on the processor a few rows a turn of
// the event loop, and again whenever the camera or the scene has come to rest.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <string>

#include "filters/core/scene/document.h"

class QLabel;

namespace boxprobe {

class PublishedPicture;
class SceneRenderer;
class Viewport;
class Workspace;

class PublishedOverlay : public QObject {
  Q_OBJECT

 public:
  explicit PublishedOverlay(Workspace& workspace);
  ~PublishedOverlay() override;

  /// A form as PublishedPicture names it; empty: none.
  void show(const std::string& form);
  /// The camera, the scene, its maps or the window's shape changed.
  void invalidate();
  /// Drawn as far as it will be.
  bool complete() const { return form_.empty() || complete_; }

 private:
  void turn();
  void place();

  SceneRenderer& renderer_;
  Viewport& viewport_;
  const Document& document_;
  std::string form_;
  Scene scene_;  ///< what is drawn; outlives changes of the document
  std::unique_ptr<PublishedPicture> drawing_;
  bool complete_ = false;
  QTimer timer_;
  QLabel *picture_, *note_;
};

}  // namespace boxprobe
