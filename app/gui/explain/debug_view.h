// The debug view's parts put together: the tool that explains pixels, the card, the schematic, the rays, the colours of
// surfaces. Off, it asks the renderer for nothing.
#pragma once

#include <vtkSmartPointer.h>

#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

#include "app/gui/explain/pixel_inspector.h"
#include "app/gui/explain/ray_rig.h"
#include "filters/core/scene/document.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/surface_view.h"
#include "filters/explain/verdict.h"

class QCheckBox;
class QPushButton;
class vtkCamera;

namespace boxprobe {

class DiffuseTruth;
class ExplainCard;
class MirrorLines;
class RayPanel;
class SceneRenderer;
class SchematicInset;
class SurfaceViewPanel;
class Viewport;
class Workspace;

class DebugView : public QObject {
  Q_OBJECT

 public:
  /// The widgets belong to whatever they are put into; the viewport and the renderer must outlive this object.
  explicit DebugView(Workspace& workspace);
  ~DebugView() override;

  QWidget* panel() const { return panel_; }  ///< settings, for a dock
  ExplainCard* card() const { return card_; }
  QWidget* explainPanel() const { return explainPanel_; }   ///< the card with the schematic under it, for a dock
  SchematicInset* schematic() const { return schematic_; }  ///< under the card
  SchematicInset* inset() const { return inset_; }          ///< in the picture, if wanted
  SurfaceViewPanel* surfacePanel() const { return surfacePanel_; }
  const PixelInspector& inspector() const { return inspector_; }
  const RayRig& rays() const { return *rays_; }
  const MirrorLines& mirrorLines() const { return *mirrors_; }
  const DiffuseTruth& diffuseTruth() const { return *truth_; }

  void cameraMoved();
  /// Whatever is due before a picture is drawn.
  void update();
  /// Which rays are drawn, to be put back after others were.
  struct Rays {
    RaySettings settings;
    std::vector<RaySample> clicks;
  };
  Rays drawnRays() const { return {rays_->settings(), rays_->clicks()}; }
  void drawRays(const Rays& rays);
  /// Rays that start at what the picture shows at these places, logical pixels, as it is now.
  void drawRaysAt(const std::vector<QPointF>& positions);
  /// Of the pixel at a place, logical, as the picture is now.
  Explanation explain(const QPointF& position) const;
  /// While its GL context is current, before the renderer goes.
  void releaseGraphics();

  void setTool(bool on);
  /// While another scene than the document's is drawn, nothing is explained; what was explained is again after.
  void setPaused(bool paused);
  /// The pinned point is let go. False if there was none.
  bool unpin();
  void saveRays();
  void copyText();
  void copyJson();

 signals:
  void pictureChanged();
  void toolChanged(bool on);
  void message(const QString& line);
  void failed(const QString& line);

 private:
  void observe(Workspace& workspace);
  void setModels(const std::vector<std::shared_ptr<const Model>>& models);
  void documentChanged(const Changes& changes);
  void workEnded();  ///< captures are done: other maps may show
  void buildPanel();
  void connectParts();
  void show(const Explanation& explanation);
  void showNothing();
  void showReadout(const Explanation& explanation, const QPointF& position);
  void setSurfaceView(const SurfaceViewSettings& settings);
  void raysChanged();
  void updateMirrors();
  PixelInspector::Explain hold(const QPointF& position);
  vtkCamera* seenFrom() const;
  double pixelScale() const;

  SceneRenderer& renderer_;
  Viewport& viewport_;
  const Document& document_;
  vtkSmartPointer<vtkCamera> pinnedCamera_;  ///< null while nothing is pinned
  bool paused_ = false;
  PixelInspector inspector_;
  std::unique_ptr<RayRig> rays_;
  std::unique_ptr<MirrorLines> mirrors_;
  DiffuseTruth* truth_;
  QWidget* panel_;
  QPushButton* tool_;
  QCheckBox* schematicShown_;
  QCheckBox* mirrorsShown_;
  SurfaceViewPanel* surfacePanel_;
  RayPanel* rayPanel_;
  ExplainCard* card_;
  QWidget* explainPanel_;
  SchematicInset *schematic_, *inset_;
};

}  // namespace boxprobe
