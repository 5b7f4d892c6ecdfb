// The implementation of ActorProbes: a probe set (probe_set.h), and the state of a foreign renderer for it: which
// actors it shows and where, their keys, its light, and when it draws.
#pragma once

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/vtk/actors/surroundings.h"
#include "filters/vtk/frame/picture_frames.h"
#include "filters/vtk/probes/probe_set.h"
#include "filters/vtk/scene/scene_content.h"
#include "filters/vtk/surface/vtkProbePass.h"

namespace boxprobe {

/// Where another prop of the renderer draws an actor: an assembly its parts.
struct ActorPlace {
  vtkProp* owner = nullptr;  ///< the outermost prop, which the renderer has
  std::array<double, 6> bounds{};
  std::array<double, 16> matrix{};
};

/// What the renderer showed when captures were last planned, by keys.
struct ShownContent {
  std::vector<std::string> objects;  ///< in the order of content.objects; empty for objects that captures do not show
  std::string lights;                ///< everything that all objects depend on
  int sky = 0;
  bool operator==(const ShownContent& o) const { return objects == o.objects && lights == o.lights && sky == o.sky; }
};

struct ActorParts {
  explicit ActorParts(vtkRenderer* shown);
  ~ActorParts();
  ActorParts(const ActorParts&) = delete;
  ActorParts& operator=(const ActorParts&) = delete;

  /// Throws InputError without an OpenGL window, WorkError if it has no context.
  void ready();
  void starts(vtkObject* caller);
  void beginFrame(vtkRenderer* drawn);
  void endFrame(vtkObject* caller);
  void followPicture();
  void stopRefining();
  bool showsAny(vtkRenderer* drawn) const;
  void observeWindow();
  void place();
  void assign();
  /// To be called when the list of probes, or a probe, has changed: `origins` as in ProbeSet::updateShapes().
  void probesChanged(const ProbeEntries::Origins& origins);
  void probesChanged();  ///< the list is unchanged
  void refreshSky();
  void showDarkSky();
  void setCaptureLights();
  ShownContent shownContent();
  std::string objectKey(const DrawnObject& object) const;
  std::string drawnKey(const DrawnObject& object) const;
  std::string lightsKey() const;
  CaptureInputs captureInputs();
  void clipCaptures();
  bool reaches(std::size_t index) const;
  void remarkUnreached();
  void remarkUnasked();

  /// Plans what is stale. True if there is something, or it is in progress.
  bool anyStale();
  /// Starts with what is stale, or with all probes. False if there is nothing to do, or it failed; see the error.
  bool begin(bool all);
  /// One unit of work. True if there is more.
  bool step();
  /// Drops work in progress, which stays stale.
  void dropWork();
  void release();

  /// Everything that the next frame of the renderer depends on.
  std::string pictureKey() const;
  /// The props that a refined picture consists of.
  std::vector<vtkProp*> picturedProps() const;
  /// Why the renderer's picture cannot be refined; empty: it can.
  std::string refusedRefinement() const;
  /// Draws a frame of a refined picture. True if there are more.
  bool refineStep();

  std::size_t indexOf(vtkActor* actor) const {
    const auto& all = content.objects;
    return static_cast<std::size_t>(
        std::find_if(all.begin(), all.end(), [&](const DrawnObject& object) { return object.actor == actor; }) -
        all.begin());
  }

  vtkSmartPointer<vtkRenderer> renderer;
  bool nothing = false;  ///< constructed without a renderer
  vtkNew<vtkCallbackCommand> observer;
  std::vector<vtkWeakPointer<vtkObject>> observed;  ///< the window and all of its renderers
  vtkWeakPointer<vtkRenderWindow> observedWindow;
  std::function<void()> beforeFrame;     ///< called before the window draws, or null
  std::function<void()> afterFrame;      ///< called after the renderer has drawn, or null
  std::function<void(double)> progress;  ///< of captures, 0 to 1, or null
  std::shared_ptr<DrawState> state;
  SceneContent content;  ///< its scene holds probes and sky; its objects represent the actors
  Scene captured;        ///< its probes as captured: their state when captures were planned, with clipping distances
  ProbeSet probes;
  PictureFrames frames;
  RefineSettings refineTo;     ///< what refineStep() goes to; no rays: nothing is refined, and nothing is compared
  bool refining = false;       ///< until the picture changes
  int restless = 0;            ///< refineStep()'s last frames that showed something else each time
  std::uint64_t pictures = 0;  ///< counts pictures that show another scene, or from elsewhere
  std::string pictureShown;    ///< pictureKey() of the last
  int probeChanges = 0;        ///< counts changes of boxes, techniques and the like
  bool assigned = false;       ///< all objects, to the current probes
  std::map<vtkActor*, int> framesWithout;  ///< that should have drawn it, but in which nothing asked for its pass
  std::map<vtkProp*, ActorPlace> parts;
  /// Near distances found so far, in the order of the probes: a dragged box keeps its distance, and so its maps.
  std::vector<double> nearDistances;
  std::optional<ShownContent> planned;            ///< empty: captures have to be planned
  bool working = false;                           ///< between begin() and the last step()
  vtkSmartPointer<vtkOpenGLRenderWindow> window;  ///< whose context is used; null: none
  /// Registered with the window, which notifies textures before its context is destroyed.
  vtkSmartPointer<vtkTextureObject> contextWatch;
  RendererSurroundings surroundings;
  bool skyGiven = false;  ///< by setSky, in place of the renderer's environment
  vtkNew<vtkSkyProp> lightSky;
  int skies = 1;  ///< counts skies, for keys
  bool seamlessBefore = false;
  std::vector<std::string> remarks;
};

}  // namespace boxprobe
