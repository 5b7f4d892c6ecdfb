// Brings the picture up to the document: syncs the renderer, has pictures drawn and captures made in turns of the event
// loop, and cheaper techniques while something moves. What fails stops the work and is told as one line.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <string>

#include "filters/core/scene/document.h"

namespace boxprobe {

class MotionPreview;
class RenderScheduler;
class RestRefinement;
class SceneRenderer;
class Viewport;

class PictureWork : public QObject {
  Q_OBJECT

 public:
  /// `beforePicture` is called with the view as it will be drawn. Everything must outlive this.
  PictureWork(const Document& document, SceneRenderer& renderer, Viewport& viewport,
              std::function<void()> beforePicture, QObject* parent);

  RenderScheduler& scheduler() { return *scheduler_; }
  MotionPreview& motion() { return *motion_; }
  RestRefinement& refinement() { return *refinement_; }
  /// What is shown is to show its techniques as they are, such as a lesson: asked before a picture is refined.
  void setPlainWhere(std::function<bool()> plain) { plain_ = std::move(plain); }

  /// Before any view of the document asks the renderer. While something is dragged the renderer puts off what only the
  /// final value needs: programs, further bounces.
  void syncScene(const Changes& changes);
  /// An edit ended, whichever way.
  void editSettled();
  void setReflectionsShown(bool shown);
  /// The scene's camera of that index; nothing for an index it does not have.
  void showCamera(int index);
  /// Its first camera, or one that sees everything.
  void resetCamera();
  /// So long nobody has edited anything: programs are then made for the scene as it is.
  static constexpr int kRestMilliseconds = 2000;
  void setRest(int milliseconds);

 signals:
  void cameraPlaced();
  void failed(const QString& line);
  /// The first picture with all captures done is on the screen.
  void firstPictureComplete();

 private:
  template <typename Work>
  void guarded(const Work& work);
  void draw();
  void workEnded();
  void tellError();
  void place(const Camera& camera);
  void rested();
  bool everRests() const;

  const Document& document_;
  SceneRenderer& renderer_;
  Viewport& viewport_;
  std::function<void()> beforePicture_;
  RenderScheduler* scheduler_;
  MotionPreview* motion_;
  RestRefinement* refinement_;
  std::function<bool()> plain_;
  QTimer rest_;  ///< since the last edit
  bool firstPictureDone_ = false;
  std::string toldError_;
};

}  // namespace boxprobe
