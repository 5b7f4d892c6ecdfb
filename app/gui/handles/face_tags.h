// The live error beside the handles of the selected probe's faces; the worst face's is marked, and a click on it moves
// the face to where the box is least wrong. Beside them the spot that was looked for. Called by the main window; knows
// where handles stand on the screen, no mouse and no document.
#pragma once

#include <QObject>
#include <array>
#include <functional>
#include <optional>

#include "app/gui/edit/probe_gauge.h"
#include "filters/vtk/widgets/view_projection.h"

class QLabel;
class QToolButton;
class QWidget;

namespace boxprobe {

class FaceTags : public QObject {
  Q_OBJECT

 public:
  struct Hooks {
    std::function<ViewProjection()> view;
    std::function<bool()> shown;  ///< the handles of the box's faces are
  };
  /// Over `picture`, whose children the tags become.
  FaceTags(ProbeGauge& gauge, const Editor& editor, Hooks hooks, QWidget* picture);

  /// The view, the probe or what is shown changed.
  void follow();
  /// Points at it until the next gauge or nothing comes.
  void showSpot(const std::optional<WorstSpot>& spot);

 private:
  void place(QWidget* tag, const glm::dvec3& positionWorld) const;

  ProbeGauge& gauge_;
  const Editor& editor_;
  Hooks hooks_;
  QWidget* picture_;
  std::array<QToolButton*, kFaces> faces_{};
  QLabel* spotTag_;
  std::optional<WorstSpot> spot_;
};

}  // namespace boxprobe
