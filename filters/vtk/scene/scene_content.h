// The contents of the picture besides probes: the scene's values, and the VTK objects made from them.
#pragma once

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/geometry/scene_lamps.h"
#include "filters/core/geometry/sight_lines.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/io/cube/sky_picture.h"
#include "filters/vtk/draw/scene_resources.h"
#include "filters/vtk/scene/model_actors.h"
#include "filters/vtk/surface/vtkSkyProp.h"

class vtkCulledRenderer;
class vtkRenderer;

namespace boxprobe {

struct SceneContent {
  Scene scene;
  std::vector<std::shared_ptr<const Model>> given;   ///< in the order of scene.models
  std::vector<std::shared_ptr<const Model>> models;  ///< as drawn: objects that too many probes reach are divided
  int modelGeneration = 0;                           ///< counts replacements of the models
  std::vector<DrawnObject> objects;
  std::vector<vtkSmartPointer<vtkLight>> lights;
  vtkNew<vtkSkyProp> sky;
  vtkSkyProp* skyLight = nullptr;              ///< lights in its place; null: the sky itself
  std::shared_ptr<const SceneLamps> lamps;     ///< null unless they are drawn as shapes
  SightLinesMaker sightLines;                  ///< traces what hides lamps; null: nothing does
  std::shared_ptr<const ImageRgbaF> skyImage;  ///< null unless the sky is an image
  SkyPictureNotes skyNotes;                    ///< of that image
  std::size_t lightsGiven = 0;  ///< of scene.lights; behind them the sun of the sky's image, if it has one

  /// Bounds of all visible objects; a box around the origin if there are none.
  Box bounds() const;
  std::vector<vtkLight*> lightPointers() const;

  /// Divides the given models for the scene's probes; returns whether anything changed.
  bool divideModels();

  /// Creates actors for the current models, or moves existing ones if only placements changed.
  void rebuildObjects(vtkCulledRenderer* renderer, const std::shared_ptr<DrawState>& state);
  /// Adds the visible objects to the renderer: as its own props or, if there are many, as those that it culls.
  void showObjects(vtkCulledRenderer* renderer);
  /// The visible objects' actors, if there are many those in view: for passes, which draw what they get.
  std::vector<vtkProp*> shownProps(vtkCulledRenderer* renderer) const;
  /// Sets the camera's near and far distances for the visible scene.
  void resetClippingRange(vtkCulledRenderer* renderer) const;
  /// Are they culled? Then the renderer's indices refer to `culled`, which has the objects' indices.
  bool many = false;
  std::vector<std::size_t> culled;
  Box culledBounds;  ///< of all of them
  /// Gives the renderer its lights, and `resources` those that are listed.
  void rebuildLights(vtkRenderer* renderer, SceneResources& resources);
  /// Finds the lamps that are drawn as shapes, before the lights are rebuilt; skipped unless emissive objects, their
  /// placement, a light source or a probe's box changed. A light source at the place of a lamp that no probe draws
  /// counts by itself. Returns whether the lamps changed.
  bool findLamps();
  bool probesDrawn = true;  ///< false: no probe is drawn, and so no lamp as a shape
  /// Reads the sky's image if it has a new one. Throws InputError. Its sun, if it is to be drawn as a light, is taken
  /// out of it, unless `sunStays`: lights are others' there.
  void rebuildSky(bool sunStays = false);
  /// Sets the scene, with the sun of the sky's image behind its lights; `newSky`: rebuilds the sky. Returns whether the
  /// sun is another. Throws InputError.
  bool setScene(const Scene& given, bool newSky);
  /// The scene as it was set, without that sun.
  Scene givenScene() const;
  std::string skyImageFile() const { return skyImageRead_ ? skyImageRead_->file : std::string(); }

 private:
  bool placeObjects();
  std::vector<bool> lightsAlone() const;  // per lamp: does it have a light source, and no probe that draws it?

  std::vector<std::shared_ptr<const Model>> builtModels_;  ///< the source of the objects
  std::vector<std::string> builtFiles_;
  std::optional<SkyImage> skyImageRead_;
  std::optional<SkySun> sun_;  ///< of the sky's image
  std::string lampsKey_;
  std::shared_ptr<const SceneLamps> foundLamps_;
  std::vector<bool> lightsAlone_;
};

}  // namespace boxprobe
