/**
 * @class vtkTargetPass
 * @brief draws given props into a framebuffer of ours instead of the window's
 *
 * A render pass, so that VTK itself activates the textures of the actors. The props are not added to the renderer:
 * removing a prop from a renderer releases its buffers and textures, which the window's renderer still uses.
 */
#pragma once

#include <vtkNew.h>
#include <vtkRenderPass.h>

#include <vector>

#include "filters/vtk/gl/opengl.h"

class vtkProp;
class vtkSequencePass;

class vtkTargetPass : public vtkRenderPass {
 public:
  static vtkTargetPass* New();
  vtkTypeMacro(vtkTargetPass, vtkRenderPass)

      GLuint Framebuffer = 0;
  /// x, y, width, height in pixels of the framebuffer; may extend beyond it, to draw a part of a larger picture.
  int Viewport[4] = {0, 0, 1, 1};
  bool Blend = true;
  bool Clear = true;   ///< before drawing
  bool Empty = false;  ///< clears to nothing, in place of the renderer's background
  std::vector<vtkProp*> Props;

  void Render(const vtkRenderState* s) override;

 protected:
  vtkTargetPass();
  ~vtkTargetPass() override;

 private:
  vtkNew<vtkSequencePass> Content;
};
