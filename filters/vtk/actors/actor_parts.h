// What the probes of another program's actors are made of: the actors with their passes, what the probes show, and the
// captures. Owned by ActorProbes, which is what programs see.
#pragma once

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "filters/core/geometry/probe_index.h"
#include "filters/vtk/actors/vtkActorProbesPass.h"
#include "filters/vtk/capture/bake_runner.h"
#include "filters/vtk/probes/probe_light.h"
#include "filters/vtk/probes/shown_probes.h"
#include "filters/vtk/scene/scene_content.h"

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
  vtkSmartPointer<vtkActorProbesPass> pass;
  ActorState state;
  bool assigned = false;  ///< by `state` and the probes as they are
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

  Graphics& ready();
  void beginFrame();
  void endFrame();
  void assign();
  void probesChanged();
  void finish(Graphics& graphics, BakeItem item);
  void captureSky(Graphics& graphics);
  void captureProbes(Graphics& graphics);
  FaceSource everythingSeen(bool sky) const;
  void show(std::size_t index, std::shared_ptr<const ProbeMaps> maps);
  /// The object's functions of these names.
  void capture();
  void release();
  std::vector<LitActor>::iterator find(vtkActor* actor) {
    return std::find_if(actors.begin(), actors.end(), [&](const LitActor& lit) { return lit.actor == actor; });
  }

  vtkSmartPointer<vtkRenderer> renderer;
  vtkNew<vtkCallbackCommand> observer;
  std::shared_ptr<ActorDraws> draws;
  std::shared_ptr<DrawState> state;  ///< within `draws`
  SceneContent content;              ///< its scene holds probes and sky; its objects stand for the actors
  ShownProbes shownProbes;
  ProbeLight light;
  ProbeIndex places;
  std::vector<LitActor> actors;  ///< in the order of content.objects
  std::vector<vtkSmartPointer<vtkLight>> captureLights;
  std::unique_ptr<Graphics> graphics;
  bool skyStale = true;
  bool seamlessBefore = false;
  double exposure = 1.0;
};

}  // namespace boxprobe
