#include "filters/vtk/surface/vtkSkyProp.h"

#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>
#include <tuple>
#include <utility>

#include "filters/vtk/draw/display_source.h"
#include "filters/vtk/surface/camera_uniforms.h"

vtkStandardNewMacro(vtkSkyProp);

vtkSkyProp::vtkSkyProp() {
  this->PickableOff();
}

vtkSkyProp::~vtkSkyProp() = default;

void vtkSkyProp::SetDrawState(std::shared_ptr<boxprobe::DrawState> state) {
  this->State = std::move(state);
  this->Passes.clear();
}

// Of the window's frames alone. A gradient is as blurred as it gets.
boxprobe::Background vtkSkyProp::BackgroundNow() const {
  if (!this->State->pass().countDraws || this->Shown == boxprobe::Background::Environment) {
    return boxprobe::Background::Environment;
  }
  const bool blurs = this->Image && this->State->resources.sky;
  return this->Shown != boxprobe::Background::Blurred || blurs ? this->Shown : boxprobe::Background::Environment;
}

// A program for what the sky is: software renderers work out both sides of a branch.
boxprobe::FullScreenPass& vtkSkyProp::ChosenPass() {
  const boxprobe::SceneResources& resources = this->State->resources;
  const boxprobe::Background background = this->BackgroundNow();
  const std::string switches = background == boxprobe::Background::Plain     ? "#define BP_PLAIN\n"
                               : background == boxprobe::Background::Color   ? "#define BP_ONE_COLOR\n"
                               : background == boxprobe::Background::Blurred ? "#define BP_SKY_MAP\n"
                               : this->Image                                 ? "#define BP_SKY_IMAGE\n"
                                                                             : "";
  const std::string sun = this->Sun && this->State->pass().sunDisc ? "#define BP_SKY_SUN\n" : "";
  const bool quick = this->State->tuning != nullptr;
  const std::string key = switches + sun + boxprobe::displayKey(resources.tone, quick);
  const auto found = this->Passes.find(key);
  if (found != this->Passes.end()) {
    return found->second;
  }
  const std::string source =
      switches + sun + boxprobe::joinShaderSources({"shared/sky.glsl", "gpu/output_uniforms.glsl"}) +
      boxprobe::displaySource(resources.tone, quick) + boxprobe::joinShaderSources({"gpu/sky.glsl"});
  return this->Passes
      .emplace(std::piecewise_construct, std::forward_as_tuple(key),
               std::forward_as_tuple("gpu/sky.glsl", source, &this->State->counts.counters, "gpu/sky_vertex.glsl"))
      .first->second;
}

void vtkSkyProp::SetSky(const boxprobe::Sky& sky, double rotationDegrees,
                        std::shared_ptr<const boxprobe::ImageRgbaF> image) {
  this->RotationDegrees = rotationDegrees;
  if (const auto* gradient = std::get_if<boxprobe::SkyGradient>(&sky)) {
    this->Gradient = *gradient;
  } else if (const auto* color = std::get_if<boxprobe::SkyColor>(&sky)) {
    this->Gradient = {color->color, color->color, color->color};
  }
  this->ImageChanged = this->ImageChanged || image != this->Image;
  this->Image = std::move(image);
  this->Modified();
}

void vtkSkyProp::SetSkyFromWorld(const glm::dmat3& skyFromWorld) {
  this->SkyFromWorld = skyFromWorld;
  this->Modified();
}

int vtkSkyProp::RenderOpaqueGeometry(vtkViewport* viewport) {
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();

  if (this->ImageChanged) {
    this->ReleaseGraphicsResources(nullptr);
    this->ImageChanged = false;
    if (this->Image) {
      glGenTextures(1, &this->ImageTexture);
      const boxprobe::BoundTexture bound(window, GL_TEXTURE_2D, this->ImageTexture);
      glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, this->Image->width, this->Image->height, 0, GL_RGBA, GL_FLOAT,
                   this->Image->pixels.data());
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
  }

  vtkCamera* camera = renderer->GetActiveCamera();
  const double aspect =
      camera->GetUseExplicitAspectRatio() ? camera->GetExplicitAspectRatio() : renderer->GetTiledAspectRatio();
  const double vertical =
      camera->GetParallelProjection() ? 0.0 : std::tan(0.5 * camera->GetViewAngle() * 3.14159265358979323846 / 180.0);
  const float tangents[2] = {static_cast<float>(vertical * aspect), static_cast<float>(vertical)};

  // Behind everything already drawn: passes only where depth is still that of the cleared buffer.
  const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  const vtkOpenGLState::ScopedglEnableDisable test(state, GL_DEPTH_TEST);
  const vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  const vtkOpenGLState::ScopedglDepthFunc function(state);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_LEQUAL);
  // The quad lies in the middle of the depth range; push it to the far end.
  glDepthRange(1.0, 1.0);

  std::unique_ptr<boxprobe::BoundTexture> image, map;
  if (this->BackgroundNow() == boxprobe::Background::Blurred) {
    map = std::make_unique<boxprobe::BoundTexture>(window, GL_TEXTURE_CUBE_MAP,
                                                   this->State->resources.sky->radiance.handle());
  } else if (this->Image) {
    image = std::make_unique<boxprobe::BoundTexture>(window, GL_TEXTURE_2D, this->ImageTexture);
  }
  this->ChosenPass().draw(window, [&](vtkShaderProgram* program) {
    program->SetUniform3f("bpSkyTop", &this->Gradient.top.x);
    program->SetUniform3f("bpSkyHorizon", &this->Gradient.horizon.x);
    program->SetUniform3f("bpSkyGround", &this->Gradient.ground.x);
    // The map of a blurred sky lies along the world's axes.
    std::array<float, 9> skyFromView =
        boxprobe::viewToTurnedRotation(camera, map != nullptr ? 0.0 : this->RotationDegrees);
    if (map == nullptr && this->SkyFromWorld != glm::dmat3(1.0)) {
      const glm::mat3 turned = glm::mat3(this->SkyFromWorld) * glm::make_mat3(skyFromView.data());
      std::copy_n(glm::value_ptr(turned), 9, skyFromView.begin());
    }
    program->SetUniformMatrix3x3("bpSkyFromView", skyFromView.data());
    program->SetUniform2f("bpTangents", tangents);
    program->SetUniformf("bpExposure", this->State->pass().exposure);
    if (map != nullptr) {
      program->SetUniformi("bpSkyMap", map->unit());
      program->SetUniformf("bpSkyLevel", static_cast<float>(vtkSkyProp::BlurredLevel(*this->State->resources.sky)));
    } else if (image) {
      program->SetUniformi("bpSkyImage", image->unit());
    }
    if (program->IsUniformUsed("bpSunRadiance")) {
      const double radius = 0.5 * glm::radians(this->Sun->angleDegrees), sine = std::sin(radius);
      constexpr double kMost = 65504.0;  // of half floats
      const glm::vec3 towards(this->Sun->towards);
      const glm::vec3 radiance(
          glm::min(glm::dvec3(this->Sun->irradiance) / (3.14159265358979323846 * sine * sine), kMost));
      program->SetUniform3f("bpSunTowards", &towards.x);
      // The chord to the edge: cosines of small angles are all near 1.
      program->SetUniformf("bpSunRadius", static_cast<float>(2.0 * std::sin(0.5 * radius)));
      program->SetUniform3f("bpSunRadiance", &radiance.x);
    }
    if (program->IsUniformUsed("bpColor")) {
      const glm::vec3 light = boxprobe::lightShownAs(this->BackgroundColor, this->State->resources.tone) /
                              std::max(this->State->exposure(), 1.0e-12f);
      program->SetUniform3f("bpColor", &light.x);
    }
    if (program->IsUniformUsed("bpPixelSize")) {
      int shown[4];
      state->vtkglGetIntegerv(GL_VIEWPORT, shown);
      const float pixel[2] = {1.0f / static_cast<float>(shown[2]), 1.0f / static_cast<float>(shown[3])};
      program->SetUniform2f("bpPixelSize", pixel);
      program->SetUniformf("bpPlainLight", 1.0f / std::max(this->State->exposure(), 1.0e-12f));
    }
  });
  glDepthRange(0.0, 1.0);
  return 1;
}

void vtkSkyProp::ReleaseGraphicsResources(vtkWindow* window) {
  if (this->ImageTexture != 0) {
    glDeleteTextures(1, &this->ImageTexture);
    this->ImageTexture = 0;
    this->ImageChanged = true;
  }
  if (window == nullptr) {
    return;
  }
  for (auto& [switches, pass] : this->Passes) {
    pass.release();
  }
}
