// What a renderer shows and is lit by past all of its actors, read from its own properties: the environment texture of
// image-based lighting, and the background. Reads vtkTexture's image on the CPU; draws nothing.
#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <string>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/math/shared/display_math.h"

class vtkRenderer;
class vtkTexture;

namespace boxprobe {

/// A sky, with the axes it stands in: pictureFromWorld takes a world direction to the one that the sky is asked for.
struct OrientedSky {
  Sky sky = SkyColor{};
  std::shared_ptr<const ImageRgbaF> image;  ///< in place of `sky`: latitude-longitude, rows from the top, linear
  glm::dmat3 pictureFromWorld{1.0};
};

class RendererSurroundings {
 public:
  /// Reads what the renderer has now; a texture's image only where it is another one than the last time. Returns
  /// whether anything changed. Not while it draws. `tone` tells the curve that display colours are encoded by.
  bool read(vtkRenderer* renderer, Tone tone);

  /// What lights surfaces where no probe has weight: the environment texture while UseImageBasedLighting is on, along
  /// EnvironmentUp and EnvironmentRight as VTK takes them; nothing (null) without.
  const OrientedSky* light() const { return lit_ ? &light_ : nullptr; }
  /// What a capture sees past all actors: the environment that lights, else the renderer's background, a gradient one
  /// along EnvironmentUp. Display colours become linear light.
  const OrientedSky& backdrop() const { return lit_ ? light_ : background_; }
  /// Empty, or why the environment texture cannot be read; one line.
  const std::string& problem() const { return problem_; }

 private:
  void readTexture(vtkTexture* texture, vtkRenderer* renderer);

  std::string key_;
  std::string textureKey_;
  bool lit_ = false;
  OrientedSky light_, background_;
  std::string problem_;
};

}  // namespace boxprobe
