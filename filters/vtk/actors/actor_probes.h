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
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"

class vtkActor;
class vtkRenderer;

namespace boxprobe {

struct BakedMaps;
struct ProbeMaps;

class ActorProbes {
 public:
  /// `renderer` belongs to a vtkOpenGLRenderWindow by the time it is first drawn, which must outlive this object or
  /// its releaseGraphics(). An actor that a further renderer shows as well is seen there as from this one's camera.
  explicit ActorProbes(vtkRenderer* renderer);
  ~ActorProbes();
  ActorProbes(const ActorProbes&) = delete;
  ActorProbes& operator=(const ActorProbes&) = delete;

  /// World frame and scene units of the renderer; returns its index, from 0. Throws InputError, with the field's path,
  /// at a value that is out of range, a name that is taken, or a mode other than Baked; nothing has changed then.
  std::size_t addProbe(const Probe& probe);
  /// The same for a probe that is there. It keeps its maps, which are looked up from where they were captured: a box
  /// may be dragged without capturing again.
  void setProbe(std::size_t index, const Probe& probe);
  const std::vector<Probe>& probes() const;

  /// Light it by the probes whose influence it meets, at most four, from the next frame on. `seenByProbes`: captures
  /// show it, too. An actor that was added before only takes over that.
  void addActor(vtkActor* actor, bool seenByProbes = true);
  /// VTK's own shading again.
  void removeActor(vtkActor* actor);
  void removeAllActors();

  /// What is reflected where no probe says otherwise, and seen by captures past all actors; by default black. The
  /// renderer's own background is not touched. Throws InputError for a picture that cannot be read.
  void setSky(const Sky& sky, double rotationDegrees = 0.0);
  /// Display colour = (exposure x linear light)^(1/2.2) of actors with probes; 1 unless set, which is VTK's.
  void setExposure(double exposure);
  /// VTK up to 9.1 leaves emissive factors out where there is no emissive texture, and its properties' default factor
  /// is white. On, they show: for actors whose factors are meant, such as vtkGLTFImporter's. Off unless set.
  void setEmission(bool shown);
  /// Light that meets more than one microfacet; Energy::Single unless set.
  void setEnergy(Energy energy);

  /// Captures and filters all probes from the actors that were added, lit by the renderer's lights as they stand
  /// (headlights where the camera is now). Draws off the screen. Returns false if something failed: see error().
  /// Throws InputError while the renderer has no window.
  bool capture();
  /// Maps from elsewhere in place of a capture: a baked file's (loadBakedProbe), or those that another renderer
  /// of the same OpenGL context shows.
  void setMaps(std::size_t index, const BakedMaps& maps);
  void setMaps(std::size_t index, std::shared_ptr<const ProbeMaps> maps);
  /// Null before the first capture.
  std::shared_ptr<const ProbeMaps> maps(std::size_t index) const;

  /// Empty while all is well; else the first failure, one line: a line of VTK's shader that was not there, an actor
  /// that is not shaded physically, a driver that refuses a program. Such actors are drawn without reflections.
  const std::string& error() const;
  void clearError();

  /// Frees what the graphics side holds, with the window still there. Captures start over afterwards.
  void releaseGraphics();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace boxprobe
