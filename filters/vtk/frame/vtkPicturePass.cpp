#include "filters/vtk/frame/vtkPicturePass.h"

#include <vtkCamera.h>
#include <vtkLightsPass.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkOverlayPass.h>
#include <vtkProp.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkShaderProgram.h>
#include <vtkTranslucentPass.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <unordered_set>

#include "filters/core/base/errors.h"
#include "filters/math/sampling/van_der_corput.h"
#include "filters/vtk/draw/display_source.h"
#include "filters/vtk/draw/pass_scope.h"
#include "filters/vtk/frame/vtkTargetPass.h"
#include "filters/vtk/surface/glass_order.h"

vtkStandardNewMacro(vtkPicturePass);

namespace {

// Looks through another place of every pixel while it lives, so that edges and what mirrors show are averaged over a
// pixel's area. Not by the sequence of the rays: place and ray would go together.
class PlaceInPixel {
 public:
  PlaceInPixel(vtkCamera* camera, int frame, int width, int height) : camera_(camera) {
    camera->GetWindowCenter(center_);
    camera->SetWindowCenter(center_[0] + (2.0 * boxprobe::vanDerCorput(frame + 1, 2) - 1.0) / width,
                            center_[1] + (2.0 * boxprobe::vanDerCorput(frame + 1, 3) - 1.0) / height);
  }
  ~PlaceInPixel() { camera_->SetWindowCenter(center_[0], center_[1]); }
  PlaceInPixel(const PlaceInPixel&) = delete;
  PlaceInPixel& operator=(const PlaceInPixel&) = delete;

 private:
  vtkCamera* camera_;
  double center_[2] = {0.0, 0.0};
};

}  // namespace

vtkPicturePass::vtkPicturePass() {
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkOverlayPass> overlay;
  passes->AddItem(lights);
  passes->AddItem(opaque);
  passes->AddItem(translucent);
  passes->AddItem(overlay);
  this->OnTop->SetPasses(passes);
}

vtkPicturePass::~vtkPicturePass() = default;

void vtkPicturePass::SetDrawState(std::shared_ptr<boxprobe::DrawState> state) {
  this->State = std::move(state);
  this->Average = std::make_unique<boxprobe::FrameAverage>(&this->State->counts.counters);
  this->Blur = std::make_unique<boxprobe::ReflectionBlur>(&this->State->counts.counters);
  this->Presented.clear();
}

void vtkPicturePass::Render(const vtkRenderState* s) {
  try {
    this->RenderPicture(s);
  } catch (const boxprobe::Error& error) {
    // An exception must not propagate through VTK's renderer, which would stay in the middle of a frame.
    this->State->counts.fail(error.what());
  }
}

void vtkPicturePass::RenderPicture(const vtkRenderState* s) {
  vtkRenderer* renderer = s->GetRenderer();
  std::vector<vtkProp*> pictured = this->Props, others;
  if (this->Framebuffer == 0) {
    // In the renderer's order without culled props; objects that the renderer culls itself are not among its props.
    if (!this->Culled) pictured.clear();
    const std::unordered_set<vtkProp*> all(this->Props.begin(), this->Props.end());
    for (int i = 0; i < s->GetPropArrayCount(); ++i) {
      vtkProp* prop = s->GetPropArray()[i];
      if (all.count(prop) == 0) {
        others.push_back(prop);
      } else if (!this->Culled) {
        pictured.push_back(prop);
      }
    }
  }
  // All frames are done: the result is shown again. But what is drawn on top is compared with its depth, which must
  // have the same range.
  const double* range = renderer->GetActiveCamera()->GetClippingRange();
  const bool complete = this->Average->frames() >= std::max(this->Limit, 1);
  if (!complete || !std::equal(range, range + 2, this->DepthRange)) {
    this->DrawFrame(renderer, pictured);
    std::copy(range, range + 2, this->DepthRange);
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    if (!complete) {
      this->Average->add(window, this->Frame);
    }
    if (this->BlurredRays > 0) {
      this->Blur->draw(window, renderer->GetActiveCamera(), this->Average->sums(), this->Average->frames(), this->Frame,
                       this->BlurredRays * this->Average->frames());
    }
  }
  this->Present(renderer);
  if (this->Framebuffer != 0) return;
  vtkRenderState onTop(renderer);
  onTop.SetPropArrayAndCount(others.data(), static_cast<int>(others.size()));
  this->OnTop->Render(&onTop);
}

// Resolving several samples per pixel first would mix surfaces at an edge, which smoothing has to distinguish: uses a
// finer picture instead.
int vtkPicturePass::Finer() const {
  return this->BlurredRays > 0 && this->Samples > 1 ? 2 : 1;
}

void vtkPicturePass::DrawFrame(vtkRenderer* renderer, const std::vector<vtkProp*>& props) {
  const bool apart = this->BlurredRays > 0;
  const int finer = this->Finer();
  this->Frame.allocate(finer * this->Width, finer * this->Height, finer > 1 ? 0 : this->Samples,
                       apart ? boxprobe::FrameTarget::kMostAttachments : 1);
  this->Target->Framebuffer = this->Frame.framebuffer();
  this->Target->Viewport[2] = this->Frame.width();
  this->Target->Viewport[3] = this->Frame.height();
  const boxprobe::PassScope scope(*this->State, [this](boxprobe::PassSettings& pass) {
    pass.exposure = boxprobe::kLinearOutput;
    pass.frame = this->Average->frames();
  });
  std::optional<PlaceInPixel> place;
  if (this->Average->framesBefore() > 0) {  // a refined picture's
    place.emplace(renderer->GetActiveCamera(), this->Average->frames(), this->Width, this->Height);
  }
  this->DrawInOrder(renderer, props);
  this->Frame.resolve(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
}

// Opaque surfaces write every attachment, and are seen through glass; the sky writes only the first attachment;
// translucent surfaces are blended over both.
void vtkPicturePass::DrawInOrder(vtkRenderer* renderer, const std::vector<vtkProp*>& props) {
  std::vector<vtkProp*> opaque, sky, translucent;
  for (vtkProp* prop : props) {
    const bool blended = prop != this->Sky && (prop->HasTranslucentPolygonalGeometry() != 0 || boxprobe::isGlass(prop));
    (prop == this->Sky ? sky : blended ? translucent : opaque).push_back(prop);
  }
  this->DrawProps(renderer, opaque, true, false);
  boxprobe::BehindPicture behind;
  if (this->Behind && !translucent.empty()) {
    if (!this->BehindCopy) this->BehindCopy = std::make_unique<boxprobe::BehindFrame>(&this->State->counts.counters);
    try {
      behind = this->BehindCopy->take(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()), this->Frame);
    } catch (const boxprobe::Error& refused) {
      this->State->counts.fail(refused.what());  // glass then shows only probes
    }
  }
  this->DrawProps(renderer, sky, false, false);
  const boxprobe::PassScope scope(*this->State, [&](boxprobe::PassSettings& pass) { pass.behind = behind; });
  this->DrawProps(renderer, translucent, false, true);
}

void vtkPicturePass::DrawProps(vtkRenderer* renderer, const std::vector<vtkProp*>& props, bool clear, bool blend) {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const bool every = props.empty() || props.front() != this->Sky;
  {
    const boxprobe::PassState saved(window);
    window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Frame.framebuffer());
    this->Frame.drawTo(every);
  }
  this->Target->Clear = clear;
  this->Target->Empty = this->Over;
  this->Target->Blend = blend;
  this->Target->Props = props;
  vtkRenderState content(renderer);
  this->Target->Render(&content);
}

boxprobe::FullScreenPass& vtkPicturePass::PresentedBy(boxprobe::Tone tone) {
  const auto found = this->Presented.find(tone);
  if (found != this->Presented.end()) {
    return found->second;
  }
  const std::string source = boxprobe::joinShaderSources({"gpu/output_uniforms.glsl"}) +
                             boxprobe::displaySource(tone, false) +
                             boxprobe::joinShaderSources({"gpu/present_picture.glsl"});
  return this->Presented
      .emplace(std::piecewise_construct, std::forward_as_tuple(tone),
               std::forward_as_tuple("gpu/present_picture.glsl", source, &this->State->counts.counters))
      .first->second;
}

void vtkPicturePass::Present(vtkRenderer* renderer) {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  const boxprobe::FrameTarget& sums = this->Average->sums();
  if (this->Framebuffer == 0) {
    // VTK leaves both to its camera, which is not used while a pass is set.
    state->vtkglViewport(this->X, this->Y, this->Width, this->Height);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(this->X, this->Y, this->Width, this->Height);
    renderer->Clear();
  }
  const boxprobe::PassState saved(window);
  const vtkOpenGLState::ScopedglDepthFunc function(state);
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  const vtkOpenGLState::ScopedglBlendFuncSeparate factors(state);
  if (this->Framebuffer != 0) {
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Framebuffer);
    state->vtkglViewport(0, 0, this->Width, this->Height);
  }
  // Depth is written only while it is tested.
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglDepthMask(GL_TRUE);
  const bool over = this->Over && this->Framebuffer == 0;
  if (over) {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  const bool blurred = this->BlurredRays > 0;
  const int frames = this->Average->frames(), framesBefore = this->Average->framesBefore();
  const double share = framesBefore > 0 && this->Share ? this->Share(frames) : 1.0;
  const boxprobe::BoundTexture before(window, GL_TEXTURE_2D,
                                      framesBefore > 0 ? this->Average->sumsBefore().texture(0) : sums.texture(0));
  const boxprobe::BoundTexture color(window, GL_TEXTURE_2D, blurred ? this->Blur->color() : sums.texture(0));
  const boxprobe::BoundTexture depth(window, GL_TEXTURE_2D, this->Frame.depth());
  this->PresentedBy(this->State->resources.tone).draw(window, [&](vtkShaderProgram* program) {
    program->SetUniformi("bpColor", color.unit());
    program->SetUniformi("bpDepth", depth.unit());
    program->SetUniformi("bpFiner", this->Finer());
    program->SetUniformi("bpOver", over ? 1 : 0);
    const int corner[2] = {this->Framebuffer == 0 ? this->X : 0, this->Framebuffer == 0 ? this->Y : 0};
    program->SetUniform2i("bpCorner", corner);
    program->SetUniformf("bpScale", blurred ? 1.0f : static_cast<float>(share / std::max(frames, 1)));
    program->SetUniformi("bpBefore", before.unit());
    program->SetUniformf("bpBeforeScale", static_cast<float>((1.0 - share) / std::max(framesBefore, 1)));
    program->SetUniformf("bpExposure", this->Framebuffer == 0 ? this->State->pass().exposure : boxprobe::kLinearOutput);
  });
}

boxprobe::PictureChange vtkPicturePass::GetChange(vtkWindow* window, double exposure) const {
  auto* openGl = vtkOpenGLRenderWindow::SafeDownCast(window);
  return boxprobe::pictureChange(this->Average->meanBefore(openGl), this->Average->mean(openGl), exposure);
}

void vtkPicturePass::KeepPart(vtkWindow* window) {
  this->Part = this->Average->mean(vtkOpenGLRenderWindow::SafeDownCast(window));
}

boxprobe::PictureChange vtkPicturePass::GetChangeWithin(vtkWindow* window, double exposure) {
  const std::vector<float> part = std::move(this->Part);
  this->Part.clear();
  if (part.empty()) {
    return {};
  }
  return boxprobe::pictureChange(part, this->Average->mean(vtkOpenGLRenderWindow::SafeDownCast(window)), exposure);
}

void vtkPicturePass::ReleaseTargets() {
  this->Frame.release();
  if (this->Average) this->Average->releaseSums();
  if (this->Blur) this->Blur->releaseTargets();
  if (this->BehindCopy) this->BehindCopy->releaseTextures();
}

void vtkPicturePass::ReleaseGraphicsResources(vtkWindow* window) {
  this->Superclass::ReleaseGraphicsResources(window);
  this->Target->ReleaseGraphicsResources(window);
  this->OnTop->ReleaseGraphicsResources(window);
  this->Frame.release();
  if (this->Average) this->Average->release();
  if (this->Blur) this->Blur->release();
  if (this->BehindCopy) this->BehindCopy->release();
  for (auto& [tone, pass] : this->Presented) pass.release();
}
