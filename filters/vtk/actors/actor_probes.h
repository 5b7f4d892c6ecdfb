// Reflection probes for the actors of any VTK renderer. Their mappers, properties, lights, camera and window stay the
// same; their physically based shading reflects box-projected probes. Supports vtkPolyDataMapper,
// vtkCompositePolyDataMapper2 (vtkCompositePolyDataMapper since VTK 9.3) and vtkGlyph3DMapper. After removal of an
// actor or destruction VTK draws its own pictures again.
//
//   ActorProbes probes(renderer);
//   probes.addProbe(probe);       // a box, a capture origin, a technique: filters/core/scene/scene.h
//   probes.addActor(actor);       // its property set to physically based shading
//   probes.capture();             // six faces and a prefiltered chain for each probe, once the scene is complete
//   window->Render();             // as usual
//
// vtkReflectionProbes (vtkReflectionProbes.h) offers the same as a vtkObject: it finds the renderer's actors and
// captures changes by itself. Prefer it in new programs.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/base/export.h"
#include "filters/core/scene/scene.h"
#include "filters/vtk/frame/refinement.h"

class vtkActor;
class vtkRenderer;

namespace boxprobe {

struct BakedMaps;
struct ProbeMaps;

class BOXPROBE_EXPORT ActorProbes {
 public:
  /// `renderer` must belong to a vtkOpenGLRenderWindow when it is first drawn, and the window must outlive this object
  /// or its releaseGraphics(). An actor that another renderer of the window also shows has the same probes there, with
  /// that renderer's camera. A null renderer is an error().
  explicit ActorProbes(vtkRenderer* renderer);
  ~ActorProbes();
  ActorProbes(const ActorProbes&) = delete;
  ActorProbes& operator=(const ActorProbes&) = delete;

  /// World frame and scene units of the renderer; returns the index, from 0. Throws InputError with the field's path,
  /// and changes nothing, for a value out of range, an existing name, or a mode other than Baked.
  std::size_t addProbe(const Probe& probe);
  /// The same at an index; later probes move down.
  void insertProbe(std::size_t index, const Probe& probe);
  /// Replaces a probe. It keeps its maps, which are sampled from where they were captured: dragging a box needs no
  /// recapture.
  void setProbe(std::size_t index, const Probe& probe);
  const std::vector<Probe>& probes() const;
  /// Later probes move up. Throws InputError for an invalid index.
  void removeProbe(std::size_t index);

  /// Lights the actor from the next frame on by the probes whose influence it meets, at most four. `seenByProbes`: also
  /// shown in captures; for an actor that was added before only this changes. An actor without physically based shading
  /// (unlit, Phong) reflects nothing and is captured as it looks. Null, or an actor that another object lights, is an
  /// error() and returns false.
  bool addActor(vtkActor* actor, bool seenByProbes = true);
  /// Restores VTK's own shading.
  void removeActor(vtkActor* actor);
  void removeAllActors();

  /// Sets what is reflected where no probe has weight, and what captures see behind all actors. By default it is the
  /// renderer's: its environment texture while UseImageBasedLighting is on, along EnvironmentUp and EnvironmentRight;
  /// else there is no light, and captures see the renderer's background. Throws InputError for a picture that cannot be
  /// read.
  void setSky(const Sky& sky, double rotationDegrees = 0.0);
  /// Returns to the renderer's environment.
  void clearSky();
  /// Factor on the linear light of actors with probes before display encoding; 1, as in VTK, by default.
  void setExposure(double exposure);
  /// Tone curve. The default, Tone::AsVtk, encodes with VTK's power of 1 / 2.2, as for all other actors; other tones
  /// use the sRGB curve.
  void setTone(Tone tone);
  /// VTK up to 9.1 ignores emissive factors without an emissive texture, and the default factor of its properties is
  /// white. Turn this on for actors whose factors are meant, such as vtkGLTFImporter's. Off by default.
  void setEmission(bool shown);
  /// Treatment of light that meets more than one microfacet; Energy::Single by default.
  void setEnergy(Energy energy);

  /// Captures and filters all probes, from the actors that were added and the renderer's lights at their current
  /// positions (headlights: at the camera). Draws off-screen. Returns false on failure: see error(); clears an earlier
  /// error. Throws InputError if the renderer has no window. The default near and far distances of probes, 0.01 and
  /// 1000, are replaced by values derived from the box and the actors.
  bool capture();
  /// The same for stale maps only.
  bool update();
  /// update() in steps of one face or one mip level, for windows that must stay responsive: call it between frames
  /// while it returns true. Maps are shown when complete.
  bool updateStep();
  /// Do maps show another state than the renderer's current one? Changed, added, moved, recoloured or removed actors
  /// make maps that show them stale, except for faces that do not; lights make all maps stale; a probe's origin, axes
  /// or capture settings its own maps; a box makes none stale. Lights that follow the camera are compared by their
  /// settings, not by position.
  bool stale();
  /// Progress of captures, 0 to 1; null for none.
  void setProgress(std::function<void(double)> progress);
  /// `before` is called before the renderer's window draws, for instance to update(); `after` when the renderer has
  /// drawn. Null for none.
  void setFrameCalls(std::function<void()> before, std::function<void()> after);
  /// Uses maps from elsewhere instead of a capture: a baked file's (loadBakedProbe), or those of another renderer of
  /// the same OpenGL context.
  void setMaps(std::size_t index, const BakedMaps& maps);
  void setMaps(std::size_t index, std::shared_ptr<const ProbeMaps> maps);
  /// What refineStep() goes to: for a view that rests. No rays (default): nothing is refined, and no frame is compared
  /// with the one before.
  void setRefinement(const RefineSettings& settings);
  /// Draws the window's next frame as a refined picture: rays of the whole lobe in place of the techniques, a few a
  /// pixel and frame, averaged in linear light (filters/vtk/README.md). Returns whether there are further frames. Any
  /// frame that shows something else, or from elsewhere, is the techniques' own again. False, with nothing drawn, if
  /// nothing is asked for, inside a frame, and if the renderer has a pass, smoothing, shadows or peeled layers of
  /// VTK's.
  bool refineStep();
  /// Counts pictures that show something else than the one before, or from elsewhere.
  std::uint64_t pictures() const;
  /// Is the last picture refined?
  bool refining() const;
  RefineState refineState() const;
  /// Of refineStep()'s frames: 0 to 1, 1 at the end.
  double refineProgress() const;
  /// Empty, or one line: why refineStep() refuses this renderer.
  std::string refusedRefinement() const;
  /// Null before the first capture.
  std::shared_ptr<const ProbeMaps> maps(std::size_t index) const;

  /// Empty, or the first failure in one line: a line missing in VTK's shader, a program that the driver refuses. Such
  /// actors are drawn without reflections.
  const std::string& error() const;
  void clearError();
  /// Warnings about the last capture, such as a probe that lights nothing.
  const std::vector<std::string>& remarks() const;

  /// Releases OpenGL resources while the window still exists. Captures start over afterwards.
  void releaseGraphics();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace boxprobe
