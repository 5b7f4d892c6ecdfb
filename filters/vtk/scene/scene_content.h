// What is in the picture besides probes: the scene's values with the VTK objects made from them. Owned by the scene
// renderer, read by the probe set.
#pragma once

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

#include "filters/core/geometry/scene_lamps.h"
#include "filters/core/geometry/sight_lines.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/vtk/scene/model_actors.h"
#include "filters/vtk/surface/vtkSkyProp.h"

class vtkCulledRenderer;
class vtkRenderer;

namespace boxprobe {

struct SceneContent {
  Scene scene;
  std::vector<std::shared_ptr<const Model>> given;   ///< in the order of scene.models
  std::vector<std::shared_ptr<const Model>> models;  ///< as drawn: objects that too many probes reach are in pieces
  int modelGeneration = 0;                           ///< counts replacements of the models
  std::vector<DrawnObject> objects;
  std::vector<vtkSmartPointer<vtkLight>> lights;
  vtkNew<vtkSkyProp> sky;
  vtkSkyProp* skyLight = nullptr;              ///< what lights in its place; null: it does
  std::shared_ptr<const SceneLamps> lamps;     ///< null unless they are drawn as shapes
  SightLinesMaker sightLines;                  ///< traces what hides lamps; null: nothing does
  std::shared_ptr<const ImageRgbaF> skyImage;  ///< null unless the sky is an image
  std::size_t skyTexelsNotFinite = 0;          ///< of that image; they were set to 0

  /// Bounds of all visible objects; a box around the origin when there is none.
  Box bounds() const;
  std::vector<vtkLight*> lightPointers() const;

  /// Divides the given models for the scene's probes; returns whether that changed anything.
  bool divideModels();

  /// Actors for the models as they are now, or the present ones moved if that is all that changed.
  void rebuildObjects(vtkCulledRenderer* renderer, const std::shared_ptr<DrawState>& state);
  /// Puts the visible objects into the renderer: as its own props, or, when there are many, as those it culls.
  void showObjects(vtkCulledRenderer* renderer);
  /// The visible objects' actors, of many those in the view: for passes, which draw what they are given.
  std::vector<vtkProp*> shownProps(vtkCulledRenderer* renderer) const;
  /// The camera's near and far distances, for what there is to see.
  void resetClippingRange(vtkCulledRenderer* renderer) const;
  /// Are they culled? Then the renderer's indices are those of `culled`, which has the objects'.
  bool many = false;
  std::vector<std::size_t> culled;
  Box culledBounds;  ///< of them all
  void rebuildLights(vtkRenderer* renderer);
  /// Finds the lamps that are drawn as shapes, before the lights are rebuilt; nothing unless what shines, where it
  /// stands, a light source or a probe's box is another. A light source in the place of a lamp that no probe draws is
  /// counted with none. Returns whether they are others.
  bool findLamps();
  bool probesDrawn = true;  ///< false: no probe is drawn with, and so no lamp as a shape
  /// Reads the sky's image if it has one and it is not the one at hand. Throws InputError.
  void rebuildSky();
  const std::string& skyImageFile() const { return skyImageFile_; }

 private:
  bool placeObjects();
  std::vector<bool> lightsAlone() const;  // of each lamp found: has it a light source, and no probe that draws it?

  std::vector<std::shared_ptr<const Model>> builtModels_;  ///< what the objects were made from
  std::vector<std::string> builtFiles_;
  std::string skyImageFile_;
  std::string lampsKey_;
  std::shared_ptr<const SceneLamps> foundLamps_;
  std::vector<bool> lightsAlone_;
};

}  // namespace boxprobe
