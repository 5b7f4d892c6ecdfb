#include "filters/vtk/frame/mirror_painter.h"

#include <vtkCamera.h>
#include <vtkCullerCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <glm/geometric.hpp>

#include "filters/vtk/draw/pass_scope.h"
#include "filters/vtk/frame/vtkTargetPass.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

MirrorPainter::MirrorPainter(vtkOpenGLRenderWindow* window, std::shared_ptr<DrawState> state,
                             const SceneContent* content)
    : window_(window),
      state_(std::move(state)),
      content_(content),
      renderer_(vtkSmartPointer<vtkRenderer>::New()),
      pass_(vtkSmartPointer<vtkTargetPass>::New()),
      camera_(vtkSmartPointer<vtkCamera>::New()) {
  renderer_->GetCullers()->RemoveAllItems();
  renderer_->AutomaticLightCreationOff();
  renderer_->SetLightFollowCamera(false);
  pass_->Clear = false;
  renderer_->SetPass(pass_);
}

MirrorPainter::~MirrorPainter() = default;

// A mask of a material has to be sampled even for depth; everything else is drawn for depth without lighting.
vtkProp* MirrorPainter::twinOf(std::size_t index, bool depthOnly) {
  const DrawnObject& object = content_->objects[index];
  const bool masked = object.material.alphaMode == AlphaMode::Mask;
  vtkSmartPointer<vtkActor>& twin = twins_[{index, depthOnly}];
  if (!twin && depthOnly && !masked) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputDataObject(object.actor->GetMapper()->GetInputDataObject(0, 0));
    mapper->ScalarVisibilityOff();
    twin = vtkSmartPointer<vtkActor>::New();
    twin->SetMapper(mapper);
    twin->GetProperty()->LightingOff();
    twin->GetProperty()->SetBackfaceCulling(object.actor->GetProperty()->GetBackfaceCulling());
    twin->SetForceOpaque(object.actor->GetForceOpaque());
    twin->SetForceTranslucent(object.actor->GetForceTranslucent());
  } else if (!twin) {
    const auto lit = makeTwin(object, state_);
    lit->GetPass()->SetHeights(!depthOnly);
    twin = lit;
  }
  twin->SetUserMatrix(object.actor->GetUserMatrix());
  if (auto* lit = vtkProbeActor::SafeDownCast(twin)) {
    static const auto kUnlit = [] {
      auto binding = std::make_shared<ProbeBinding>();
      binding->lighting = Lighting::Unlit;
      return std::shared_ptr<const ProbeBinding>(std::move(binding));
    }();
    lit->GetPass()->SetBinding(depthOnly ? kUnlit : object.pass->GetSharedBinding());
  }
  return twin;
}

vtkCamera* MirrorPainter::camera(const PictureView& view) {
  const glm::dvec3 focal = view.eye + view.forward * std::max(1.0, 1.0e-3 * glm::length(view.eye));
  camera_->SetPosition(view.eye.x, view.eye.y, view.eye.z);
  camera_->SetFocalPoint(focal.x, focal.y, focal.z);
  camera_->SetViewUp(view.up.x, view.up.y, view.up.z);
  camera_->SetParallelProjection(view.parallel);
  vtkNew<vtkMatrix4x4> projection;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) projection->SetElement(row, column, view.clipFromView[column][row]);
  }
  camera_->SetExplicitProjectionTransformMatrix(projection);
  camera_->UseExplicitProjectionTransformMatrixOn();
  return camera_;
}

void MirrorPainter::paint(const PictureView& view, const glm::dvec4& heightPlane,
                          const std::vector<std::size_t>& moving, const std::vector<std::size_t>& hiding,
                          MirrorTarget& target) {
  std::vector<vtkProp*> solid, shown;
  for (const std::size_t i : hiding) solid.push_back(twinOf(i, true));
  for (const std::size_t i : moving) shown.push_back(twinOf(i, false));
  renderer_->SetRenderWindow(window_);
  renderer_->RemoveAllLights();
  for (vtkLight* light : content_->lightPointers()) renderer_->AddLight(light);

  // Normals are transformed by the view's rotation; relative to the eye there is no translation.
  const glm::dvec3 normalView(view.viewFromEye() * glm::dvec4(glm::dvec3(heightPlane), 0.0));
  const PassScope scope(*state_, renderer_, camera(view), [&](PassSettings& pass) {
    pass.heightPlaneView = glm::vec4(glm::vec3(normalView), static_cast<float>(heightPlane.w));
    pass.exposure = kLinearOutput;
    pass.countDraws = false;
  });

  vtkOpenGLState* gl = window_->GetState();
  const vtkOpenGLState::ScopedglEnableDisable samples(gl, GL_MULTISAMPLE);
  gl->vtkglEnable(GL_MULTISAMPLE);
  target.clear(window_);
  pass_->Framebuffer = target.framebuffer();
  pass_->Viewport[2] = target.width();
  pass_->Viewport[3] = target.rows();
  if (!solid.empty()) {
    target.drawColors(window_, false);
    pass_->Props = solid;
    renderer_->Render();
    target.drawColors(window_, true);
  }
  pass_->Props = shown;
  renderer_->Render();
  target.finish(window_);
}

void MirrorPainter::release() {
  for (auto& [key, twin] : twins_) twin->ReleaseGraphicsResources(window_);
  twins_.clear();
  renderer_->SetRenderWindow(nullptr);
}

}  // namespace boxprobe
