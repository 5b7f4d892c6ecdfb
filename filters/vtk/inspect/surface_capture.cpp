#include "filters/vtk/inspect/surface_capture.h"

#include <vtkCamera.h>
#include <vtkCullerCollection.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/vtk/draw/pass_scope.h"
#include "filters/vtk/frame/vtkTargetPass.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

namespace {

/// -1 for values that our programs do not write.
int objectNumber(float written) {
  constexpr float kMost = 16777216.0f;  // floats represent all integers up to this one
  return written >= 0.0f && written <= kMost ? static_cast<int>(written + 0.5f) : -1;
}

}  // namespace

SurfaceCapture::SurfaceCapture(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state)
    : window_(window), state_(std::move(state)), renderer_(vtkSmartPointer<vtkRenderer>::New()) {
  renderer_->GetCullers()->RemoveAllItems();
  renderer_->AutomaticLightCreationOff();
  renderer_->SetLightFollowCamera(false);
  renderer_->SetBackground(0.0, 0.0, 0.0);
  renderer_->SetBackgroundAlpha(0.0);
  vtkNew<vtkTargetPass> pass;
  // A translucent surface is explained by itself, not blended with what is behind.
  pass->Blend = false;
  renderer_->SetPass(pass);
}

SurfaceCapture::~SurfaceCapture() = default;

void SurfaceCapture::allocate(int width, int height) {
  if (framebuffer_.made() && width == width_ && height == height_) return;
  release();
  width_ = width;
  height_ = height;
  std::vector<FramebufferImage> colors;
  for (GLuint& texture : textures_) {
    texture = makeTargetTexture(width, height, GL_RGBA32F, GL_RGBA);
    colors.push_back(textureImage(texture));
  }
  depth_ = makeTargetTexture(width, height, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
  framebuffer_.attach(colors, textureImage(depth_), [](GLenum) {
    return "this driver cannot draw into seven float textures at once; pixels cannot be explained";
  });
}

void SurfaceCapture::draw(vtkCamera* camera, int height, const PixelRect& rect, bool finish) {
  const PassScope scope(*state_, renderer_, camera, [&](PassSettings& settings) {
    settings.debug.view = 0;
    settings.debug.finish = finish;
    settings.exposure = kLinearOutput;
    settings.countDraws = false;
    settings.pixelOrigin = glm::ivec2(rect.x, height - rect.y - rect.height);
  });
  window_->GetState()->vtkglEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  renderer_->Render();
}

SurfaceCapture::Values SurfaceCapture::readBack(const PixelRect& rect) {
  const auto count = static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height);
  Values values;
  const PassState saved(window_);
  window_->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.handle());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i].resize(count);
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    glReadPixels(0, 0, rect.width, rect.height, GL_RGBA, GL_FLOAT, &values[i][0].x);
  }
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  return values;
}

std::vector<SurfacePixel> SurfaceCapture::capture(vtkCamera* camera, int width, int height, const PixelRect& rect,
                                                  const std::vector<vtkProp*>& props,
                                                  const std::vector<vtkLight*>& lights, bool finish) {
  allocate(rect.width, rect.height);
  vtkNew<vtkCamera> shaped;
  shaped->DeepCopy(camera);
  shaped->UseExplicitAspectRatioOn();
  shaped->SetExplicitAspectRatio(static_cast<double>(width) / height);

  auto* pass = vtkTargetPass::SafeDownCast(renderer_->GetPass());
  pass->Framebuffer = framebuffer_.handle();
  pass->Viewport[0] = -rect.x;
  pass->Viewport[1] = -(height - rect.y - rect.height);
  pass->Viewport[2] = width;
  pass->Viewport[3] = height;
  pass->Props = props;
  renderer_->SetRenderWindow(window_);
  renderer_->RemoveAllLights();
  for (vtkLight* light : lights) renderer_->AddLight(light);
  draw(shaped, height, rect, false);
  const auto count = static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height);
  const Values values = readBack(rect);
  Values finishes;
  if (finish) {
    draw(shaped, height, rect, true);
    finishes = readBack(rect);
  }

  glm::dvec3 eye;
  camera->GetPosition(&eye.x);
  glm::dvec3 towardsEye;
  camera->GetDirectionOfProjection(&towardsEye.x);
  std::vector<SurfacePixel> pixels(count);
  for (int row = 0; row < rect.height; ++row) {
    for (int column = 0; column < rect.width; ++column) {
      const auto from = static_cast<std::size_t>((rect.height - 1 - row) * rect.width + column);
      SurfacePixel& pixel = pixels[static_cast<std::size_t>(row * rect.width + column)];
      const glm::vec4 place = values[1][from];
      pixel.color = glm::vec3(values[0][from]);
      pixel.object = objectNumber(place.w);
      if (pixel.object <= 0) continue;
      SurfacePoint& p = pixel.point;
      p.pixel = glm::ivec2(rect.x + column, height - 1 - (rect.y + row));
      p.eyeWorld = eye;
      p.positionWorld = eye + glm::dvec3(place);
      p.viewWorld = camera->GetParallelProjection() != 0 ? glm::vec3(-towardsEye) : -glm::normalize(glm::vec3(place));
      p.normalWorld = glm::vec3(values[2][from]);
      p.roughness = values[2][from].w;
      p.albedo = glm::vec3(values[3][from]);
      p.metallic = values[3][from].w;
      p.emissive = glm::vec3(values[4][from]);
      p.occlusion = values[4][from].w;
      p.coatNormalWorld = glm::vec3(values[5][from]);
      p.coatRoughness = values[5][from].w;
      p.baseF0 = values[6][from].x;
      p.opacity = std::abs(values[6][from].y);
      p.backSide = values[6][from].y < 0.0f;
      p.coatStrength = values[6][from].z;
      p.coatF0 = values[6][from].w;
      if (!finish) continue;
      for (std::size_t i = 0; i < pixel.finish.size(); ++i) pixel.finish[i] = finishes[i + 1][from];
    }
  }
  return pixels;
}

void SurfaceCapture::release() {
  framebuffer_.release();
  if (textures_[0] != 0) glDeleteTextures(kAttachments, textures_.data());
  if (depth_ != 0) glDeleteTextures(1, &depth_);
  depth_ = 0;
  textures_ = {};
  width_ = height_ = 0;
  renderer_->SetRenderWindow(nullptr);
}

}  // namespace boxprobe
