#include "filters/vtk/capture/cube_capture.h"

#include <vtkCamera.h>
#include <vtkCullerCollection.h>
#include <vtkLight.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include <algorithm>

#include "filters/core/base/errors.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/math/shared/shared_math.h"
#include "filters/vtk/draw/pass_scope.h"
#include "filters/vtk/frame/vtkPicturePass.h"
#include "filters/vtk/frame/vtkTargetPass.h"

namespace boxprobe {

namespace {

// The camera of each face, so that the picture has OpenGL's orientation (shaders/shared/cube.glsl): forward is the
// face's axis, up the direction in which t grows.
glm::dvec3 faceForward(int face) {
  return glm::dvec3(shading::cubeDirection(face, 0.0f, 0.0f));
}
glm::dvec3 faceUp(int face) {
  return glm::dvec3(shading::cubeDirection(face, 0.0f, 1.0f) - shading::cubeDirection(face, 0.0f, 0.0f));
}

}  // namespace

CubeCapture::CubeCapture(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state)
    : window_(window),
      state_(std::move(state)),
      renderer_(vtkSmartPointer<vtkRenderer>::New()),
      pass_(vtkSmartPointer<vtkTargetPass>::New()),
      faceCamera_(vtkSmartPointer<vtkCamera>::New()),
      resolve_({"shared/cube.glsl", "gpu/resolve_capture.glsl"}, &state_->counts.counters) {
  // Cullers use the window's aspect ratio, not the face's.
  renderer_->GetCullers()->RemoveAllItems();
  renderer_->AutomaticLightCreationOff();
  renderer_->SetLightFollowCamera(false);
  renderer_->SetBackgroundAlpha(0.0);
  renderer_->SetPass(pass_);
  faceCamera_->SetViewAngle(90.0);
  faceCamera_->UseExplicitAspectRatioOn();
  faceCamera_->SetExplicitAspectRatio(1.0);
}

CubeCapture::~CubeCapture() = default;

void CubeCapture::prepare(int width, int height, const std::vector<vtkLight*>& lights, const glm::vec3& clearColor) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (std::max(width, height) > largest) {
    throw InputError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                     " samples is more than this driver's " + std::to_string(largest) +
                     " a side; ask for a smaller size or fewer samples");
  }
  target_.allocate(width, height);
  renderer_->SetRenderWindow(window_);
  renderer_->SetBackground(clearColor.x, clearColor.y, clearColor.z);
  renderer_->RemoveAllLights();
  for (vtkLight* light : lights) renderer_->AddLight(light);
}

void CubeCapture::draw(vtkCamera* camera) {
  const PassScope scope(*state_, renderer_, camera, [](PassSettings& pass) {
    pass.exposure = kLinearOutput;
    pass.countDraws = false;
  });
  window_->GetState()->vtkglEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  renderer_->Render();
}

void CubeCapture::renderInto(vtkCamera* camera, int width, int height, const std::vector<vtkProp*>& props,
                             const std::vector<vtkLight*>& lights, const glm::vec3& clearColor) {
  prepare(width, height, lights, clearColor);
  renderer_->SetPass(pass_);
  pass_->Framebuffer = target_.framebuffer();
  pass_->Viewport[2] = width;
  pass_->Viewport[3] = height;
  pass_->Props = props;
  draw(camera);
}

void CubeCapture::captureFace(const CaptureSettings& settings, int face, const std::vector<vtkProp*>& props,
                              const std::vector<vtkLight*>& lights, const CubeTexture& radiance,
                              const CubeTexture* distance) {
  const bool turned = settings.rotationDegrees != glm::dvec3(0.0);
  const glm::dmat3 worldFromMap = turned ? rotationMatrix(settings.rotationDegrees) : glm::dmat3(1.0);
  const glm::dvec3 focal = settings.originWorld + worldFromMap * faceForward(face);
  const glm::dvec3 up = worldFromMap * faceUp(face);
  faceCamera_->SetPosition(settings.originWorld.x, settings.originWorld.y, settings.originWorld.z);
  faceCamera_->SetFocalPoint(focal.x, focal.y, focal.z);
  faceCamera_->SetViewUp(up.x, up.y, up.z);
  faceCamera_->SetClippingRange(settings.nearDistance, settings.farDistance);
  const int size = radiance.faceSize() * settings.samplesPerTexelSide;
  const auto* color = std::get_if<glm::vec3>(&settings.clear);
  {
    // A capture always shows the scene, never the debug view.
    const PassScope scope(*state_, [](PassSettings& pass) { pass.debug.view = 0; });
    renderInto(faceCamera_, size, size, props, lights, color != nullptr ? *color : glm::vec3(0.0f));
  }

  const PassState saved(window_);
  faces_.bind(window_, radiance, face, 0, distance);
  const BoundTexture colorTexture(window_, GL_TEXTURE_2D, target_.color());
  const BoundTexture depthTexture(window_, GL_TEXTURE_2D, target_.depth());
  const auto draw = [&](int keep) {
    resolve_.draw(window_, [&](vtkShaderProgram* program) {
      program->SetUniformi("bpColor", colorTexture.unit());
      program->SetUniformi("bpDepth", depthTexture.unit());
      program->SetUniformi("bpScale", settings.samplesPerTexelSide);
      program->SetUniformi("bpFace", face);
      program->SetUniformf("bpFaceSize", static_cast<float>(radiance.faceSize()));
      program->SetUniformf("bpNear", static_cast<float>(settings.nearDistance));
      program->SetUniformf("bpFar", static_cast<float>(settings.farDistance));
      program->SetUniformi("bpKeep", keep);
    });
  };
  // Counted with an occlusion query: no texel has to be read back.
  const auto drawn = [&](int keep) {
    if (query_ == 0) glGenQueries(1, &query_);
    glBeginQuery(GL_SAMPLES_PASSED, query_);
    draw(keep);
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint texels = 0;
    glGetQueryObjectuiv(query_, GL_QUERY_RESULT, &texels);
    return texels;
  };
  const auto texels = static_cast<GLuint>(radiance.faceSize()) * static_cast<GLuint>(radiance.faceSize());
  const GLuint bad = texels - std::min(drawn(0), texels);
  if (bad == 0) return;
  draw(1);
  window_->GetState()->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  const GLuint notFinite = drawn(2);
  window_->GetState()->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state_->counts.counters.texelsNotFinite += notFinite;
  state_->counts.counters.texelsClamped += bad - notFinite;
}

void CubeCapture::drawOnce(const CaptureSettings& settings, const std::vector<vtkProp*>& props,
                           const std::vector<vtkLight*>& lights) {
  const glm::dvec3& o = settings.originWorld;
  // Its picture is never seen, so nothing has to be prepared for it.
  const PassScope scope(*state_, [](PassSettings& pass) { pass.dragging = true; });
  faceCamera_->SetPosition(o.x, o.y, o.z);
  faceCamera_->SetFocalPoint(o.x, o.y, o.z - 1.0);
  faceCamera_->SetViewUp(0.0, 1.0, 0.0);
  faceCamera_->SetClippingRange(settings.nearDistance, settings.farDistance);
  renderInto(faceCamera_, 4, 4, props, lights, glm::vec3(0.0f));
}

ImageRgbaF CubeCapture::renderFrame(vtkCamera* camera, int width, int height, int samplesPerSide,
                                    const std::vector<vtkProp*>& props, const std::vector<vtkLight*>& lights,
                                    vtkPicturePass* picture, const std::function<void(int)>& beforeFrame) {
  vtkNew<vtkCamera> shaped;
  shaped->DeepCopy(camera);
  shaped->UseExplicitAspectRatioOn();
  shaped->SetExplicitAspectRatio(static_cast<double>(width) / height);
  const int w = width * samplesPerSide, h = height * samplesPerSide;
  if (picture == nullptr) {
    renderInto(shaped, w, h, props, lights, glm::vec3(0.0f));
  } else {
    prepare(w, h, lights, glm::vec3(0.0f));
    picture->Framebuffer = target_.framebuffer();
    picture->Width = w;
    picture->Height = h;
    picture->Props = props;
    renderer_->SetPass(picture);
    for (int frame = 0; picture->Advance ? picture->Advance() : frame < picture->Limit; ++frame) {
      if (beforeFrame) beforeFrame(frame);
      draw(shaped);
    }
  }

  std::vector<float> samples(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 4);
  {
    const PassState saved(window_);
    window_->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, w, h, GL_RGBA, GL_FLOAT, samples.data());
  }
  ImageRgbaF image{width, height,
                   std::vector<float>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4)};
  const double share = 1.0 / (samplesPerSide * samplesPerSide);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double sum[4] = {};
      for (int j = 0; j < samplesPerSide; ++j) {
        for (int i = 0; i < samplesPerSide; ++i) {
          const int row = (height - 1 - y) * samplesPerSide + j;
          const int column = x * samplesPerSide + i;
          const float* s = &samples[(static_cast<std::size_t>(row) * static_cast<std::size_t>(w) +
                                     static_cast<std::size_t>(column)) *
                                    4];
          for (int c = 0; c < 4; ++c) sum[c] += s[c];
        }
      }
      float* pixel =
          &image.pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                        4];
      for (int c = 0; c < 4; ++c) pixel[c] = static_cast<float>(sum[c] * share);
    }
  }
  return image;
}

void CubeCapture::release() {
  target_.release();
  faces_.release();
  resolve_.release();
  if (query_ != 0) glDeleteQueries(1, &query_);
  query_ = 0;
  renderer_->SetRenderWindow(nullptr);
}

}  // namespace boxprobe
