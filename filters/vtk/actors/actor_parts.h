// What the probes of another program's actors are made of: the actors with their passes, what the probes show, and the
// captures. Owned by ActorProbes, which is what programs see.
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

#include "filters/core/geometry/probe_index.h"
#include "filters/vtk/actors/surroundings.h"
#include "filters/vtk/capture/bake_runner.h"
#include "filters/vtk/probes/probe_light.h"
#include "filters/vtk/probes/shown_probes.h"
#include "filters/vtk/scene/scene_content.h"
#include "filters/vtk/surface/vtkProbePass.h"

namespace boxprobe {

/// What of an actor decides which probes light it, and by which program.
struct ActorState {
  std::array<double, 6> bounds{};
  double roughnessMin = 0.0, roughnessMax = 1.0;
  bool allMetal = false;
  bool operator==(const ActorState& o) const {
    return bounds == o.bounds && roughnessMin == o.roughnessMin && roughnessMax == o.roughnessMax &&
           allMetal == o.allMetal;
  }
};

struct LitActor {
  vtkSmartPointer<vtkActor> actor;
  vtkSmartPointer<vtkProbePass> pass;
  ActorState state;
  bool assigned = false;  ///< by `state` and the probes as they are
  int framesWithout = 0;  ///< that should have drawn it, and in which nobody asked for its pass
};

/// Where another prop of the renderer draws an actor: an assembly its parts.
struct ActorPlace {
  vtkProp* owner = nullptr;  ///< the outermost one, which the renderer has
  std::array<double, 6> bounds{};
  std::array<double, 16> matrix{};
};

/// What a probe's maps were captured from.
struct CapturedFrom {
  std::string content, probe;  ///< keys; empty: not captured
  bool given = false;          ///< maps from elsewhere, which never go stale
  double nearDistance = 0.0;   ///< that was found for it; a box that is dragged keeps it, and its maps
};

/// Captures under way: a bounce of all probes before the next bounce of any.
struct CaptureWork {
  std::vector<std::size_t> probes;
  std::vector<std::string> probeKeys;  ///< of those, when the work began
  std::string contentKey;
  int bounce = 1, bounces = 1;
  std::size_t next = 0;  ///< of `probes`, in this bounce
  std::vector<std::shared_ptr<const ProbeMaps>> made;
  bool sky = false;  ///< the sky is being captured
  int units = 1, done = 0;
};

struct ActorParts {
  /// What takes a window to be made.
  struct Graphics {
    Graphics(vtkOpenGLRenderWindow* shownIn, const std::shared_ptr<DrawState>& state)
        : window(shownIn), capture(shownIn, state), runner(shownIn, state, &capture, &times) {}
    vtkSmartPointer<vtkOpenGLRenderWindow> window;
    Times times;
    CubeCapture capture;
    BakeRunner runner;
  };

  explicit ActorParts(vtkRenderer* shown);
  ~ActorParts();
  ActorParts(const ActorParts&) = delete;
  ActorParts& operator=(const ActorParts&) = delete;

  /// Throws InputError without a window of OpenGL, WorkError while it has no context.
  Graphics& ready();
  void starts(vtkObject* caller);
  void beginFrame(vtkRenderer* drawn);
  void endFrame();
  void observeWindow();
  void place();
  void assign();
  void probesChanged();
  void refreshSky();
  void captureSky(Graphics& graphics);
  void startNext(Graphics& graphics);
  void finishBounce();
  FaceSource everythingSeen(bool sky) const;
  void show(std::size_t index, std::shared_ptr<const ProbeMaps> maps);
  std::string contentKey();
  std::string probeKey(std::size_t index) const;
  CaptureSettings clippedSettings(std::size_t index) const;
  bool reaches(std::size_t index) const;
  void remarkUnreached();
  void remarkUnasked();
  bool skyStale() const { return skyShown != skyWanted; }

  /// Plans captures of all probes, or of the stale ones. False: there are none, or it failed; see the error.
  bool begin(bool all);
  /// One unit of work. True while there is more.
  bool step();
  bool stale(std::size_t index, const std::string& content) const;
  bool anyStale();
  /// What is under way is given up; it counts as stale still.
  void dropWork();
  void release();

  std::vector<LitActor>::iterator find(vtkActor* actor) {
    return std::find_if(actors.begin(), actors.end(), [&](const LitActor& lit) { return lit.actor == actor; });
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
  ShownProbes shownProbes;
  ProbeLight light;
  ProbeIndex places;
  std::vector<LitActor> actors;  ///< in the order of content.objects
  std::map<vtkProp*, ActorPlace> parts;
  std::vector<CapturedFrom> captured;  ///< in the order of the probes
  std::unique_ptr<CaptureWork> work;
  std::vector<vtkSmartPointer<vtkLight>> captureLights;
  std::unique_ptr<Graphics> graphics;
  /// Registered with the window, which tells its like before its context goes.
  vtkSmartPointer<vtkTextureObject> contextWatch;
  RendererSurroundings surroundings;
  bool skyGiven = false;  ///< by setSky, in place of the renderer's surroundings
  vtkNew<vtkSkyProp> lightSky;
  int skyWanted = 1, skyShown = 0;
  bool seamlessBefore = false;
  std::vector<std::string> remarks;
};

}  // namespace boxprobe
