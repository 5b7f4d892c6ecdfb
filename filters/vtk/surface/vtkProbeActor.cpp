#include "filters/vtk/surface/vtkProbeActor.h"

#include <vtkDataObject.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <algorithm>

#include "filters/core/base/scope_exit.h"
#include "filters/vtk/gl/opengl.h"
#include "filters/vtk/surface/glass_draw.h"

vtkStandardNewMacro(vtkProbeActor);

vtkProbeActor::vtkProbeActor() {
  this->Pass->Attach(this, this);
}

// VTK 9.1 never releases a pass if the property keys that contain it are discarded.
vtkProbeActor::~vtkProbeActor() {
  this->Pass->Detach();
}

void vtkProbeActor::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pass:\n";
  this->Pass->PrintSelf(os, indent.GetNextIndent());
}

void vtkProbeActor::SetShape(vtkPolyData* data, std::shared_ptr<const boxprobe::SurfaceMaterial> surface) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  const auto map = [&mapper](bool wanted, const char* name) {
    if (wanted) {
      mapper->MapDataArrayToVertexAttribute(name, name, vtkDataObject::FIELD_ASSOCIATION_POINTS);
    }
  };
  if (surface) {
    map(surface->uv[0], "bpUv0");
    map(surface->uv[1], "bpUv1");
    map(surface->colors, "bpColor");
    map(surface->tangents, "bpTangent");
  }
  this->SetMapper(mapper);
  this->Pass->SetSurface(std::move(surface));
}

vtkMTimeType vtkProbeActor::GetRedrawMTime() {
  return std::max(this->Superclass::GetRedrawMTime(), this->Pass->GetShaderStageMTime());
}

void vtkProbeActor::Render(vtkRenderer* renderer, vtkMapper* mapper) {
  boxprobe::DrawState* state = this->Pass->GetDrawState();
  if (state == nullptr) {
    this->Superclass::Render(renderer, mapper);
    return;
  }
  if (this->Pass->GetHiddenInView() && renderer == state->shown.GetPointer()) {
    return;
  }
  vtkRenderer* const before = state->drawing;
  const boxprobe::ScopeExit drawn([state, before] {
    state->bound.clear();
    state->drawing = before;
  });
  state->drawing = renderer;
  this->Pass->Prepare(this);
  const boxprobe::FrameParts leftOut = this->Pass->GetDisabledParts();
  if ((leftOut & boxprobe::kObjectPart) != 0) {
    return;
  }
  if ((leftOut & boxprobe::kRasterPart) != 0) {
    glEnable(GL_RASTERIZER_DISCARD);
    this->Superclass::Render(renderer, mapper);
    glDisable(GL_RASTERIZER_DISCARD);
    return;
  }
  if (!this->Pass->DrawsGlass() || renderer->GetSelector() != nullptr) {
    this->Superclass::Render(renderer, mapper);
    return;
  }
  // Not by the superclass, which would set the depth mask.
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const int passes = boxprobe::drawGlassPasses(window->GetState(), this->Pass->GetSurface()->glass, [&](bool) {
    mapper->Render(renderer, this);
    this->Pass->SetAgain();
  });
  if (state->pass().countDraws) {
    ++state->counts.counters.glassDraws;
    state->counts.counters.glassPasses += static_cast<std::uint64_t>(passes);
  }
}
