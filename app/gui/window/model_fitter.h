// What a bare model was taken for, and the way to have it otherwise: a menu, and a button with the same menu in the
// status bar; over the picture a question where unit or up axis are doubtful. Finds the exposure once the first picture
// is complete.
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/load_scene.h"
#include "filters/core/scene/document.h"

class QAction;
class QMainWindow;
class QMenu;
class QToolButton;

namespace boxprobe {

class ImportBar;
class Workspace;

class ModelFitter : public QObject {
  Q_OBJECT

 public:
  ModelFitter(Workspace& workspace, QMainWindow* window);

  /// As one undo step: probes, cameras, lights and sky are fitted again. Nothing: as it is found.
  void treatAs(std::optional<ModelKind> kind);
  void lightBy(std::optional<FitLight> light);
  /// The same with the model file read in another unit, another of its axes up.
  void readAs(LengthUnit unit, UpAxis up);
  /// Any scene: from the next complete picture, as an undo step.
  void exposeAgain();
  const std::optional<ModelFit>& fit() const { return fit_; }

 signals:
  void message(const QString& text);
  void failed(const QString& line);

 private:
  /// A scene or a model was opened and is on show.
  void opened(const LoadedScene& loaded);
  /// The model's file is read otherwise than before, by an edit or its undo: the view goes with it.
  void modelsChanged();
  /// A lesson's scene takes its place for a while.
  void setBorrowed(bool borrowed);
  /// A frame was drawn: the exposure is found if that waits for it and nothing is left to capture.
  void pictureDrawn();
  void buildMenu(QMainWindow* window);
  void refit(const QString& label, const Document::Edit& first = {});
  void askAgain();
  void expose();
  void exposeStep(double exposure);
  void update();

  Workspace& workspace_;
  QMenu* menu_ = nullptr;
  QToolButton* button_ = nullptr;
  ImportBar* bar_;
  std::vector<std::pair<std::optional<ModelKind>, QAction*>> kinds_;
  std::vector<std::pair<std::optional<FitLight>, QAction*>> lights_;
  FitWishes wishes_;
  LengthUnit unit_ = LengthUnit::Metre;  ///< as shown
  UpAxis up_ = UpAxis::Y;
  std::optional<ModelFit> fit_;  ///< of the bare model on show
  bool exposureWaits_ = false;
  bool exposureAsked_ = false;  ///< by the user
  /// The last step that fitted the model again.
  struct Refit {
    std::size_t position;
    std::string label;
  };
  std::optional<Refit> refitted_;
  bool borrowed_ = false;
};

}  // namespace boxprobe
