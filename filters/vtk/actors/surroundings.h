// What a renderer shows and is lit by behind all of its actors, from its own properties: the environment texture of
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

/// A sky with its axes: pictureFromWorld takes a world direction to the direction in which the sky is sampled.
struct OrientedSky {
  Sky sky = SkyColor{};
  std::shared_ptr<const ImageRgbaF> image;  ///< in place of `sky`: latitude-longitude, rows from the top, linear
  glm::dmat3 pictureFromWorld{1.0};
};

class RendererSurroundings {
 public:
  /// Reads the renderer's current state; a texture's image only if it has changed. Returns whether anything changed.
  /// Must not be called while it draws. `tone` gives the encoding of display colours.
  bool read(vtkRenderer* renderer, Tone tone);

  /// The light where no probe has weight: the environment texture while UseImageBasedLighting is on, along
  /// EnvironmentUp and EnvironmentRight as in VTK; else null.
  const OrientedSky* light() const { return lit_ ? &light_ : nullptr; }
  /// What a capture sees behind all actors: the environment that lights, else the renderer's background, a gradient
  /// along EnvironmentUp. Display colours are converted to linear light.
  const OrientedSky& backdrop() const { return lit_ ? light_ : background_; }
  /// Empty, or why the environment texture cannot be read, in one line.
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
