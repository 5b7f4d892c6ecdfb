// What the probes of another program's actors are made of: a probe set (probe_set.h), and what tells it of a renderer
// that is somebody else's: which actors it shows where, their keys, its light, and when it draws. Owned by ActorProbes,
// which is what programs see.
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
#include "filters/vtk/probes/probe_set.h"
#include "filters/vtk/scene/scene_content.h"
#include "filters/vtk/surface/vtkProbePass.h"

namespace boxprobe {

/// Where another prop of the renderer draws an actor: an assembly its parts.
struct ActorPlace {
  vtkProp* owner = nullptr;  ///< the outermost one, which the renderer has
  std::array<double, 6> bounds{};
  std::array<double, 16> matrix{};
};

/// What the renderer showed when captures were planned last, by keys.
struct ShownContent {
  std::vector<std::string> objects;  ///< in the order of content.objects; empty texts: captures do not show them
  std::string lights;                ///< and what all of them depend on
  int sky = 0;
  bool operator==(const ShownContent& o) const { return objects == o.objects && lights == o.lights && sky == o.sky; }
};

struct ActorParts {
  explicit ActorParts(vtkRenderer* shown);
  ~ActorParts();
  ActorParts(const ActorParts&) = delete;
  ActorParts& operator=(const ActorParts&) = delete;

  /// Throws InputError without a window of OpenGL, WorkError while it has no context.
  void ready();
  void starts(vtkObject* caller);
  void beginFrame(vtkRenderer* drawn);
  void endFrame();
  void observeWindow();
  void place();
  void assign();
  /// After the list of probes, or one of them: `origins` as ProbeSet::updateShapes() takes them.
  void probesChanged(const ProbeEntries::Origins& origins);
  void probesChanged();  ///< the list is the one it was
  void refreshSky();
  void showDarkSky();
  void setCaptureLights();
  ShownContent shownContent();
  std::string objectKey(const DrawnObject& object) const;
  std::string lightsKey() const;
  CaptureInputs captureInputs();
  void clipCaptures();
  bool reaches(std::size_t index) const;
  void remarkUnreached();
  void remarkUnasked();

  /// Plans what is stale. True: there is something, or it is being made.
  bool anyStale();
  /// Begins with what is stale, or with all probes. False: there is nothing to do, or it failed; see the error.
  bool begin(bool all);
  /// One unit of work. True while there is more.
  bool step();
  /// What is under way is given up; it counts as stale still.
  void dropWork();
  void release();

  std::size_t indexOf(vtkActor* actor) const {
    const auto& all = content.objects;
    return static_cast<std::size_t>(
        std::find_if(all.begin(), all.end(), [&](const DrawnObject& object) { return object.actor == actor; }) -
        all.begin());
  }

  vtkSmartPointer<vtkRenderer> renderer;
  bool nothing = false;  ///< made without a renderer
  vtkNew<vtkCallbackCommand> observer;
  std::vector<vtkWeakPointer<vtkObject>> observed;  ///< the window and all of its renderers
  vtkWeakPointer<vtkRenderWindow> observedWindow;
  std::function<void()> beforeFrame;     ///< called before the window draws, or null
  std::function<void()> afterFrame;      ///< called once the renderer has drawn, or null
  std::function<void(double)> progress;  ///< of captures, 0 to 1, or null
  std::shared_ptr<DrawState> state;
  SceneContent content;  ///< its scene holds probes and sky; its objects stand for the actors
  Scene captured;        ///< its probes as captures take them: when they were planned, with clipping distances
  ProbeSet probes;
  bool assigned = false;                   ///< all objects, by the probes as they are
  std::map<vtkActor*, int> framesWithout;  ///< that should have drawn it, and in which nobody asked for its pass
  std::map<vtkProp*, ActorPlace> parts;
  /// Near distances that were found, in the order of the probes: a box that is dragged keeps its own, and its maps.
  std::vector<double> nearDistances;
  std::optional<ShownContent> planned;            ///< nothing: captures have to be planned
  bool working = false;                           ///< between begin() and the last step()
  vtkSmartPointer<vtkOpenGLRenderWindow> window;  ///< whose context is ours; null: none
  /// Registered with the window, which tells its like before its context goes.
  vtkSmartPointer<vtkTextureObject> contextWatch;
  RendererSurroundings surroundings;
  bool skyGiven = false;  ///< by setSky, in place of the renderer's surroundings
  vtkNew<vtkSkyProp> lightSky;
  int skies = 1;  ///< so far
  bool seamlessBefore = false;
  std::vector<std::string> remarks;
};

}  // namespace boxprobe
