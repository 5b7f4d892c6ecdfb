// The time at which a model's animations are shown: a bar over the picture with a slider, there only for models that
// have some. The model is read again beside the window's work, at the time that was asked for last.
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/edit/background_work.h"
#include "filters/core/scene/document.h"
#include "filters/core/scene/model.h"

class QLabel;
class QMainWindow;
class QSlider;
class QToolBar;
class QToolButton;

namespace boxprobe {

class Workspace;

class AnimationTools : public QObject {
  Q_OBJECT

 public:
  using Models = std::vector<std::shared_ptr<const Model>>;
  AnimationTools(Workspace& workspace, QMainWindow* window);

 signals:
  void failed(const QString& line);

 private:
  /// Other models are on show than before, and the document speaks of them.
  void opened();
  /// What is on show is not the document's until opened() says so.
  void forget();
  /// The document's entries of models changed, by an edit or its undo.
  void modelsChanged();
  using Time = std::optional<double>;
  Time wanted() const;
  double length() const;
  void drag(int position);
  void ask(const Time& time, bool last);
  void read();
  void update();

  Workspace& workspace_;
  QToolBar* bar_;
  QSlider* slider_;
  QLabel* text_;
  QToolButton* rest_;
  BackgroundWork work_;
  /// A model and the time it was read at.
  struct Pose {
    std::shared_ptr<const Model> model;
    Time time;
  };
  void take(const Pose& pose, const Pose& before);

  std::optional<std::size_t> index_;  ///< of the model that moves
  Pose shown_;
  Pose reading_;         ///< what is on show instead of the model being read, and the time that is read
  Pose failed_;          ///< likewise: could not be read, and is not tried again
  bool taking_ = false;  ///< the model read here is put on show
};

}  // namespace boxprobe
