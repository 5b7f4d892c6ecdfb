/**
 * @class vtkPicturePass
 * @brief the picture by way of float targets: the mean of several frames in linear light, reflections smoothed
 *
 * Draws the given props in linear light, adds them to the frames drawn before, and puts the mean on the screen (or into
 * a framebuffer of ours, linear) with its depth. What else is in the renderer is drawn on top as ever, neither averaged
 * nor harmed. Set by the scene renderer while a technique asks for it, and by linear pictures; knows no scene.
 */
#pragma once

#include <vtkNew.h>
#include <vtkRenderPass.h>

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/frame/behind_frame.h"
#include "filters/vtk/frame/frame_average.h"
#include "filters/vtk/frame/refinement.h"
#include "filters/vtk/frame/reflection_blur.h"

class vtkProp;
class vtkSequencePass;
class vtkTargetPass;

class vtkPicturePass : public vtkRenderPass {
 public:
  static vtkPicturePass* New();
  vtkTypeMacro(vtkPicturePass, vtkRenderPass)

      void SetDrawState(std::shared_ptr<boxprobe::DrawState> state);
  /** What the picture is of; of the window's picture, those that are in the renderer. */
  std::vector<vtkProp*> Props;
  /** Where the picture goes; 0: to what is bound, in display colours, with the renderer's other props on top. */
  unsigned int Framebuffer = 0;
  int Width = 1, Height = 1;  ///< in pixels
  int Samples = 0;            ///< per pixel, in every frame
  bool Behind = false;        ///< some of Props are glass, seen through to the others (see behind_frame.h)
  int BlurredRays = 0;        ///< per pixel and frame, if samples are smoothed; 0: they are not
  vtkProp* Sky = nullptr;     ///< among Props: has no reflection, and is drawn behind all others
  bool Culled = false;        ///< Props are the visible ones of many, in place of the renderer's own
  int Limit = 1;              ///< number of frames; then further renders show the result again

  /** The share in the picture of a mean of so many frames, the rest being the mean before it; empty: all. */
  std::function<double(int)> Share;
  /** Called before each frame of a linear picture: is there one more? Empty: until the limit. */
  std::function<bool()> Advance;

  /** What is shown changed: the next frame is the first. */
  void Restart() { this->Average->restart(); }
  int GetFrames() const { return this->Average ? this->Average->frames() : 0; }
  /** The next frame is the first of a mean that replaces this one. */
  void Promote() { this->Average->promote(); }
  /** How far the mean is from the one before it. Reads both back. */
  boxprobe::PictureChange GetChange(vtkWindow* window, double exposure) const;

  void Render(const vtkRenderState* s) override;
  /** The pictures, not the programs. */
  void ReleaseTargets();
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  vtkPicturePass();
  ~vtkPicturePass() override;

 private:
  int Finer() const;
  void RenderPicture(const vtkRenderState* s);
  void DrawFrame(vtkRenderer* renderer, const std::vector<vtkProp*>& props);
  void DrawInOrder(vtkRenderer* renderer, const std::vector<vtkProp*>& props);
  void DrawProps(vtkRenderer* renderer, const std::vector<vtkProp*>& props, bool clear, bool blend);
  void Present(vtkRenderer* renderer);
  boxprobe::FullScreenPass& PresentedBy(boxprobe::Tone tone);

  std::shared_ptr<boxprobe::DrawState> State;
  std::unique_ptr<boxprobe::FrameAverage> Average;
  std::map<boxprobe::Tone, boxprobe::FullScreenPass> Presented;
  std::unique_ptr<boxprobe::ReflectionBlur> Blur;
  std::unique_ptr<boxprobe::BehindFrame> BehindCopy;
  boxprobe::FrameTarget Frame;
  vtkNew<vtkTargetPass> Target;
  vtkNew<vtkSequencePass> OnTop;
  double DepthRange[2] = {0.0, 0.0};  ///< clipping distances of the current depth
};
