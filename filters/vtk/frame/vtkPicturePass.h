/**
 * @class vtkPicturePass
 * @brief the picture by way of float targets: the mean of several frames in linear light, reflections smoothed
 *
 * Draws the given props in linear light, adds them to the previous frames, and writes the average to the screen (or, in
 * linear light, into a framebuffer of ours) with its depth. The renderer's other props are drawn on top, without
 * averaging. The scene renderer sets it while a technique needs it, and for linear pictures.
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
  /** The contents of the picture; for the window's picture, those in the renderer. */
  std::vector<vtkProp*> Props;
  /** The target; 0: the bound framebuffer, in display colours, with the renderer's other props on top. */
  unsigned int Framebuffer = 0;
  int Width = 1, Height = 1;  ///< in pixels
  int X = 0, Y = 0;           ///< of the lower left pixel, in the window
  bool Over = false;          ///< over what the renderer's background shows where Props leave something of it
  int Samples = 0;            ///< per pixel, in every frame
  bool Behind = false;        ///< some of Props are glass, seen through to the others (see behind_frame.h)
  int BlurredRays = 0;        ///< per pixel and frame, if samples are smoothed; 0: they are not
  vtkProp* Sky = nullptr;     ///< among Props: has no reflection, and is drawn behind all others
  bool Culled = false;        ///< Props are the visible ones of many, in place of the renderer's own
  int Limit = 1;              ///< number of frames; then further renders show the result again

  /** The weight of an average of that many frames in the picture, the rest being the previous average; empty: 1. */
  std::function<double(int)> Share;
  /** Called before each frame of a linear picture; returns false to stop. Empty: until the limit. */
  std::function<bool()> Advance;

  /** To be called when the contents have changed: the next frame is the first. */
  void Restart() { this->Average->restart(); }
  int GetFrames() const { return this->Average ? this->Average->frames() : 0; }
  /** The next frame is the first of an average that replaces this one. */
  void Promote() { this->Average->promote(); }
  /** The difference between the average and the previous one. Reads both back. */
  boxprobe::PictureChange GetChange(vtkWindow* window, double exposure) const;
  /** Keeps the average of the frames so far, for GetChangeWithin. */
  void KeepPart(vtkWindow* window);
  /** The difference between that part and the average; none if none was kept. Forgets it. */
  boxprobe::PictureChange GetChangeWithin(vtkWindow* window, double exposure);

  void Render(const vtkRenderState* s) override;
  /** Releases the pictures, but not the programs. */
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
  std::vector<float> Part;            ///< RGBA; empty: none is kept
  double DepthRange[2] = {0.0, 0.0};  ///< clipping distances of the current depth
};
