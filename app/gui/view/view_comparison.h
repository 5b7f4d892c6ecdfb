// The view in the window in up to four ways side by side: as it is, ray traced, as the scene was when the comparison
// was begun, with every probe baked or live, by another technique. The pictures are made one after the other with the
// window's own renderer, a unit of work a turn of the event loop; the document is not touched. Called by the window's
// tools; knows the renderer only as functions.
#pragma once

#include <QImage>
#include <QObject>
#include <QTimer>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/view/compare_views.h"
#include "app/gui/view/reference_trace.h"
#include "filters/core/scene/document.h"

namespace boxprobe {

/// What a view can show, "" for nothing: "now", "traced", "before", "baked", "live", and every technique's short id
/// after "technique:".
std::vector<CompareViews::Choice> viewChoices();
/// The scene as such a view shows it; nothing for "", "now" and "traced".
std::optional<Scene> viewScene(const Scene& now, const Scene& before, const QString& id);

class ViewComparison : public QObject {
  Q_OBJECT

 public:
  struct Hooks {
    std::function<bool()> ready;                    ///< the picture is at rest and can be drawn
    std::function<QImage()> picture;                ///< as it is now, without handles; draws, but tells nobody
    std::function<ImageRgbaF(const QSize&)> light;  ///< the same, linear, of so many pixels
    std::function<Camera()> camera;
    std::function<std::vector<std::shared_ptr<const Model>>()> models;
    /// The renderer draws this scene from now on, whatever the document holds.
    std::function<void(const Scene& scene, const Changes& changes)> render;
  };
  /// `document` must outlive this.
  ViewComparison(Document& document, QWidget* picture, Hooks hooks, QObject* parent = nullptr);
  ~ViewComparison() override;

  void setOn(bool on);
  bool on() const { return on_; }
  CompareViews& views() { return *views_; }
  /// Pictures are still being made, the reference aside.
  bool making() const { return on_ && (outdated_ || shown_.has_value()); }
  /// Other models are shown: off, and what the renderer draws is left to whoever shows them.
  void forget();

  void pictureDrawn();
  /// What is drawn changes by neither the document nor the camera: reflections off, another surface view.
  void pictureChanged();

 signals:
  void onChanged(bool on);
  /// The renderer draws the document's scene again, or another one from now on.
  void ownSceneShown(bool own);
  void message(const QString& text);
  void failed(const QString& line);

 private:
  void documentChanged(const Changes& changes);
  void start();
  void next();
  void takePicture();
  void comeBack();
  void wait();
  void measure();
  void traced(const QImage& picture, double share, const std::shared_ptr<const ReferencePicture>& light);
  void keep(int view, const QImage& picture);
  bool sameView() const;

  Document& document_;
  std::size_t observer_ = 0;
  CompareViews* views_;
  Hooks hooks_;
  ReferenceTrace trace_;
  QTimer rest_, poll_;
  bool on_ = false, outdated_ = false;
  Scene before_;                ///< when it was begun
  Camera camera_;               ///< of the pictures
  QSize size_;                  ///< of the widget that they were made of, logical pixels
  std::optional<Scene> shown_;  ///< what the renderer draws in place of the document's scene
  std::vector<int> left_;       ///< views whose pictures are still to be made, last first
  int view_ = 0;                ///< whose picture is being made
  std::array<QImage, CompareViews::kViews> pictures_;
  std::array<ImageRgbaF, CompareViews::kViews> lights_;  ///< of the same, where a view is traced
  std::shared_ptr<const ReferencePicture> tracedLight_;  ///< once it is as fine as they are
};

}  // namespace boxprobe
