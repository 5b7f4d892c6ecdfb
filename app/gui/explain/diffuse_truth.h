// Traced diffuse light of the current view, with which the debug view of its error compares. Made in the background as
// soon as the view rests, finer with each pass; forgotten when camera, size or scene changes.
#pragma once

#include <QObject>
#include <QSize>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/gui/view/reference_trace.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

class SceneRenderer;

class DiffuseTruth : public QObject {
  Q_OBJECT

 public:
  /// The renderer must outlive this object.
  explicit DiffuseTruth(SceneRenderer& renderer, QObject* parent = nullptr);

  /// Is the view of the error chosen?
  void setWanted(bool wanted);
  void setModels(const std::vector<std::shared_ptr<const Model>>& models);
  void sceneChanged();
  /// Before a picture of `size` device pixels is drawn. `scene`: as it is shown.
  void update(const Scene& scene, const QSize& size);
  /// Of the last pass, 1 with the last; 0 while nothing is traced.
  double share() const { return share_; }

 signals:
  /// The renderer has other light to compare with.
  void pictureChanged();
  void failed(const QString& line);

 private:
  void forget();
  void start();

  SceneRenderer& renderer_;
  ReferenceTrace trace_;
  QTimer rest_;
  std::vector<std::shared_ptr<const Model>> models_;
  Scene scene_;
  Camera camera_;
  QSize size_;
  bool wanted_ = false, outdated_ = true;
  double share_ = 0.0;
};

}  // namespace boxprobe
