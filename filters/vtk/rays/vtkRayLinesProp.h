/**
 * @class vtkRayLinesProp
 * @brief lines of constant width in pixels with a halo, over the scene they are in
 *
 * Drawn after everything else of its renderer, with depth test: hidden parts are dashed and faint. Uses one buffer of
 * ends, colours and widths, which is uploaded for new lines, but not for a moved camera. Does not affect the camera's
 * clipping range, and is not pickable. RayLayer uses it for rays.
 */
#pragma once

#include <vtkProp.h>

#include <glm/vec3.hpp>
#include <vector>

class vtkShaderProgram;

namespace boxprobe {

/// Layout as in the vertex shader. A line without length is a dot of that width.
struct DrawnLine {
  glm::vec3 from{0.0f}, to{0.0f};  ///< relative to the anchor
  glm::vec3 color{1.0f};           ///< display
  float widthPixels = 2.0f;
  float arrow = 0.0f;  ///< 1: the shaft of an arrow to `to`; 2: its head, a separate line
};

}  // namespace boxprobe

class vtkRayLinesProp : public vtkProp {
 public:
  static vtkRayLinesProp* New();
  vtkTypeMacro(vtkRayLinesProp, vtkProp)

      void SetLines(std::vector<boxprobe::DrawnLine> lines, const glm::dvec3& anchorWorld);
  /** Device pixels per logical pixel, for high-density screens. */
  void SetPixelScale(float scale);

  int RenderOverlay(vtkViewport* viewport) override;
  double* GetBounds() override { return nullptr; }
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  vtkRayLinesProp();
  ~vtkRayLinesProp() override;

 private:
  vtkRayLinesProp(const vtkRayLinesProp&) = delete;
  void operator=(const vtkRayLinesProp&) = delete;
  void Upload();
  void BuildArray();

  std::vector<boxprobe::DrawnLine> Lines;
  glm::dvec3 AnchorWorld{0.0};
  float PixelScale = 1.0f;
  bool LinesChanged = true;
  vtkShaderProgram* Program = nullptr;  // owned by the window's shader cache
  unsigned int VertexArray = 0;
  unsigned int Buffer = 0;
};
