/**
 * @class   vtkSkyProp
 * @brief   the sky of a scene, drawn behind everything
 *
 * A gradient or a latitude-longitude image at infinity. Writes alpha 0, so that a capture's alpha distinguishes
 * geometry from sky. Linear or display colours, depending on the draw state.
 */
#pragma once

#include <vtkProp.h>

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/io/cube/sky_sun.h"
#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/gl/full_screen_pass.h"

class vtkSkyProp : public vtkProp {
 public:
  static vtkSkyProp* New();
  vtkTypeMacro(vtkSkyProp, vtkProp)

      void SetDrawState(std::shared_ptr<boxprobe::DrawState> state);
  /** `image` for a SkyImage, else null. */
  void SetSky(const boxprobe::Sky& sky, double rotationDegrees, std::shared_ptr<const boxprobe::ImageRgbaF> image);
  /** A sun that was taken out of the image: shown as an even disc where it is looked at, not in captures. */
  void SetSun(const std::optional<boxprobe::SkySun>& sun) {
    this->Sun = sun;
    this->Modified();
  }
  /** Rotation of the sky, applied after `rotationDegrees`: takes a world direction to the sampled one. */
  void SetSkyFromWorld(const glm::dmat3& skyFromWorld);

  /** What the picture shows in its place; captures and linear pictures show the sky. */
  void SetBackground(boxprobe::Background background, const glm::vec3& color) {
    this->Shown = background;
    this->BackgroundColor = color;
  }
  /** The level of the sky's map that a blurred background shows: fine enough to look even. */
  static int BlurredLevel(const boxprobe::ProbeMaps& sky) { return std::max(sky.radiance.levels() - 5, 0); }

  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  double* GetBounds() override { return nullptr; }  // at infinity: must not stretch the clipping range
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  vtkSkyProp();
  ~vtkSkyProp() override;

 private:
  vtkSkyProp(const vtkSkyProp&) = delete;
  void operator=(const vtkSkyProp&) = delete;

  boxprobe::Background BackgroundNow() const;
  boxprobe::FullScreenPass& ChosenPass();

  std::shared_ptr<boxprobe::DrawState> State;
  boxprobe::SkyGradient Gradient;
  double RotationDegrees = 0.0;
  glm::dmat3 SkyFromWorld{1.0};
  std::shared_ptr<const boxprobe::ImageRgbaF> Image;
  std::optional<boxprobe::SkySun> Sun;
  unsigned int ImageTexture = 0;
  bool ImageChanged = false;
  boxprobe::Background Shown = boxprobe::Background::Environment;
  glm::vec3 BackgroundColor{0.6f};                         // as the display is to show it, linear
  std::map<std::string, boxprobe::FullScreenPass> Passes;  // by what their programs differ in
};
