// Reflection probes for the actors of somebody else's VTK renderer: their mappers, properties, lights, camera and
// window stay what they are; their physically based shading reflects box-projected probes. For vtkPolyDataMapper,
// vtkCompositePolyDataMapper2 (vtkCompositePolyDataMapper since VTK 9.3) and vtkGlyph3DMapper. Destroyed, or told to
// let an actor go, it leaves no trace: VTK draws its own pictures again.
//
//   ActorProbes probes(renderer);
//   probes.addProbe(probe);       // a box, a capture origin, a technique: filters/core/scene/scene.h
//   probes.addActor(actor);       // its property set to physically based shading
//   probes.capture();             // six faces and a prefiltered chain for each probe, once the scene stands
//   window->Render();             // the window's own, as ever
//
// vtkReflectionProbes (vtkReflectionProbes.h) is the same as a vtkObject: it finds the renderer's actors and captures
// what has changed by itself. New programs use that.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/base/export.h"
#include "filters/core/scene/scene.h"

class vtkActor;
class vtkRenderer;

namespace boxprobe {

struct BakedMaps;
struct ProbeMaps;

class BOXPROBE_EXPORT ActorProbes {
 public:
  /// `renderer` belongs to a vtkOpenGLRenderWindow by the time it is first drawn, which must outlive this object or
  /// its releaseGraphics(). An actor that a further renderer of the window shows as well has the same probes there, by
  /// that renderer's own camera. A null renderer is an error().
  explicit ActorProbes(vtkRenderer* renderer);
  ~ActorProbes();
  ActorProbes(const ActorProbes&) = delete;
  ActorProbes& operator=(const ActorProbes&) = delete;

  /// World frame and scene units of the renderer; returns its index, from 0. Throws InputError, with the field's path,
  /// at a value that is out of range, a name that is taken, or a mode other than Baked; nothing has changed then.
  std::size_t addProbe(const Probe& probe);
  /// The same at an index; those from there on move down.
  void insertProbe(std::size_t index, const Probe& probe);
  /// The same for a probe that is there. It keeps its maps, which are looked up from where they were captured: a box
  /// may be dragged without capturing again.
  void setProbe(std::size_t index, const Probe& probe);
  const std::vector<Probe>& probes() const;
  /// The probes after it move up. Throws InputError for an index that is none.
  void removeProbe(std::size_t index);

  /// Light it by the probes whose influence it meets, at most four, from the next frame on. `seenByProbes`: captures
  /// show it, too. An actor that was added before only takes over that. One that is not shaded physically (unlit,
  /// Phong) reflects nothing and is captured as it looks. Null, or an actor that another object lights, is an error()
  /// and false.
  bool addActor(vtkActor* actor, bool seenByProbes = true);
  /// VTK's own shading again.
  void removeActor(vtkActor* actor);
  void removeAllActors();

  /// What is reflected where no probe says otherwise, and seen by captures past all actors. Until it is set, the
  /// renderer's own: its environment texture while UseImageBasedLighting is on, along EnvironmentUp and
  /// EnvironmentRight; else no light, and captures see its background. Throws InputError for a picture that cannot be
  /// read.
  void setSky(const Sky& sky, double rotationDegrees = 0.0);
  /// The renderer's own again.
  void clearSky();
  /// Factor on the linear light of actors with probes before it is shown; 1 unless set, which is VTK's.
  void setExposure(double exposure);
  /// How that light is shown. Tone::AsVtk unless set: by VTK's power of 1 / 2.2, as all other actors are; by the curve
  /// of sRGB else.
  void setTone(Tone tone);
  /// VTK up to 9.1 leaves emissive factors out where there is no emissive texture, and its properties' default factor
  /// is white. On, they show: for actors whose factors are meant, such as vtkGLTFImporter's. Off unless set.
  void setEmission(bool shown);
  /// Light that meets more than one microfacet; Energy::Single unless set.
  void setEnergy(Energy energy);

  /// Captures and filters all probes from the actors that were added, lit by the renderer's lights as they stand
  /// (headlights where the camera is now). Draws off the screen. Returns false if something failed: see error(); an
  /// earlier error is forgotten. Throws InputError while the renderer has no window. A near distance of 0.01 and a far
  /// one of 1000, which probes have unless set, stand for what the box and the actors ask for.
  bool capture();
  /// The same for what is stale alone: nothing, if nothing is.
  bool update();
  /// update() in steps of one face or one mip level, for windows that must stay live: call it between frames while it
  /// returns true. Maps are shown once they are whole.
  bool updateStep();
  /// Do maps show another state than the renderer's now? Changed, added, moved, recoloured or removed actors make those
  /// stale that show them, of which the other faces are kept; lights make all stale, a probe's origin, axes or capture
  /// settings its own; a box does not. Lights that follow the camera count as they are set, not where they are.
  bool stale();
  /// Of captures, 0 to 1; null: nobody is told.
  void setProgress(std::function<void(double)> progress);
  /// Called before the renderer's window draws, a place to update() in, and after the renderer has drawn; null: nothing
  /// is.
  void setFrameCalls(std::function<void()> before, std::function<void()> after);
  /// Maps from elsewhere in place of a capture: a baked file's (loadBakedProbe), or those that another renderer
  /// of the same OpenGL context shows.
  void setMaps(std::size_t index, const BakedMaps& maps);
  void setMaps(std::size_t index, std::shared_ptr<const ProbeMaps> maps);
  /// Null before the first capture.
  std::shared_ptr<const ProbeMaps> maps(std::size_t index) const;

  /// Empty while all is well; else the first failure, one line: a line of VTK's shader that was not there, a driver
  /// that refuses a program. Such actors are drawn without reflections.
  const std::string& error() const;
  void clearError();
  /// Sentences about the last capture that are no errors, such as a probe that lights nothing.
  const std::vector<std::string>& remarks() const;

  /// Frees what the graphics side holds, with the window still there. Captures start over afterwards.
  void releaseGraphics();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace boxprobe
