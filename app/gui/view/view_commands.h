// Where the window looks from, by name: at the selection, along an axis, from a probe, from the scene's cameras, which
// it also stores, renames and deletes.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "app/gui/edit/editor.h"
#include "app/gui/edit/view_state.h"
#include "filters/core/geometry/probe_frame.h"

namespace boxprobe {

class SceneRenderer;
class SceneSurfaces;
class Viewport;

class ViewCommands : public QObject {
  Q_OBJECT

 public:
  ViewCommands(Editor& editor, const ViewState& state, SceneRenderer& renderer, Viewport& viewport,
               SceneSurfaces& surfaces, QObject* parent);

  /// The selected objects, else the selected probes' boxes, or all that is visible where nothing is selected. Where
  /// camera and selection are indoors, the camera stays in front of the walls.
  void frameSelection();
  void lookAlong(const BoxFace& face);
  /// From its capture origin, the way the camera looks now.
  void lookFromProbe();
  /// At a point of the scene, from where somebody sees it or closer on the same line, on which it reflects the same.
  void lookAtSpot(const glm::dvec3& positionWorld, const glm::dvec3& eyeWorld);
  /// The view from before the first lookAtSpot().
  void comeBack();
  /// Other models are shown: a view of those before is none of these.
  void forgetView();
  void setWalking(bool on);
  /// Takes back what was said of a view that is gone.
  void forgetHint();

  /// The view as it is now, as the scene's last camera; a name that is taken gets a number.
  void storeCamera(const QString& name);
  /// The same camera seen from where the view is now.
  void updateCamera(int index);
  void renameCamera(int index, const QString& name);
  void deleteCamera(int index);

 signals:
  void cameraMoved();
  /// There is a view to come back to, or no more.
  void canComeBack(bool can);
  void message(const QString& text);

 private:
  Camera current(const std::string& name) const;
  double aspect() const;
  Box selectedBounds() const;

  Editor& editor_;
  const ViewState& state_;
  SceneRenderer& renderer_;
  Viewport& viewport_;
  SceneSurfaces& surfaces_;
  std::optional<Camera> before_;  ///< a spot was looked at
  bool hinted_ = false;           ///< what the view lacks
};

}  // namespace boxprobe
