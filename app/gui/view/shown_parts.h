// Brings the picture up to what the window hides, isolates, outlines and cuts away, and does so by command. What is
// rendered, exported, compared or captured has everything.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "app/gui/edit/editor.h"
#include "app/gui/edit/view_state.h"
#include "filters/core/scene/document.h"
#include "filters/core/scene/model.h"

namespace boxprobe {

class SceneRenderer;
class SceneSurfaces;

class ShownParts : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    Editor& editor;
    ViewState& state;
    SceneRenderer& renderer;
    SceneSurfaces& surfaces;
    const std::vector<std::shared_ptr<const Model>>& models;
    const ViewState::Names& nodes;  ///< of all objects
  };
  ShownParts(const Parts& parts, QObject* parent);

  void documentChanged(const Changes& changes);
  /// While pictures are compared the whole scene is shown: what is measured beside it has everything, too.
  void setWhole(bool whole);

  void hideSelected();
  /// Ends isolation.
  void setHidden(const ViewState::Names& probes, const ViewState::Names& objects, bool hidden);
  /// The selected objects alone; or the selected probes and the objects that reach into their boxes. Once more: all.
  void toggleIsolation();
  /// These alone; once more: all.
  void isolate(const ViewState::Names& probes, const ViewState::Names& objects);
  /// Remembered for the next start.
  void setCutaway(bool on);

 signals:
  /// Another picture is wanted.
  void pictureChanged();
  void message(const QString& text);

 private:
  void update();
  ViewState::Names selectedProbes() const;
  ViewState::Names objectsIn(const std::vector<std::size_t>& probes) const;

  Parts parts_;
  bool whole_ = false;
};

}  // namespace boxprobe
