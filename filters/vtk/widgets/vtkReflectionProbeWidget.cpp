#include "filters/vtk/widgets/vtkReflectionProbeWidget.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkEvent.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWidgetCallbackMapper.h>
#include <vtkWidgetEvent.h>

#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"

vtkStandardNewMacro(vtkReflectionProbeWidget);

vtkReflectionProbeWidget::vtkReflectionProbeWidget() {
  vtkWidgetCallbackMapper* mapper = this->CallbackMapper;
  mapper->SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, this, SelectAction);
  mapper->SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, this, MoveAction);
  mapper->SetCallbackMethod(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, this, EndSelectAction);
  constexpr char kEscape = 27;
  mapper->SetCallbackMethod(vtkCommand::KeyPressEvent, vtkEvent::AnyModifier, kEscape, 0, "Escape",
                            vtkWidgetEvent::Reset, this, CancelAction);
}

// The superclass would leave the layers of the representation in place.
vtkReflectionProbeWidget::~vtkReflectionProbeWidget() {
  this->vtkReflectionProbeWidget::SetEnabled(0);
}

void vtkReflectionProbeWidget::SetProbe(vtkReflectionProbe* probe) {
  this->CreateDefaultRepresentation();
  if (probe == this->GetProbe()) {
    return;
  }
  this->GetReflectionProbeRepresentation()->SetProbe(probe);
  this->Finish();
  this->Modified();
}

vtkReflectionProbe* vtkReflectionProbeWidget::GetProbe() {
  auto* shown = this->GetReflectionProbeRepresentation();
  return shown != nullptr ? shown->GetProbe() : nullptr;
}

void vtkReflectionProbeWidget::SetRepresentation(vtkReflectionProbeRepresentation* representation) {
  this->SetWidgetRepresentation(representation);
}

vtkReflectionProbeRepresentation* vtkReflectionProbeWidget::GetReflectionProbeRepresentation() {
  return vtkReflectionProbeRepresentation::SafeDownCast(this->WidgetRep);
}

void vtkReflectionProbeWidget::CreateDefaultRepresentation() {
  if (this->WidgetRep == nullptr) {
    this->WidgetRep = vtkReflectionProbeRepresentation::New();
  }
}

void vtkReflectionProbeWidget::SetEnabled(int enabling) {
  if (enabling != 0 && this->Interactor != nullptr && this->Interactor->GetRenderWindow() == nullptr) {
    vtkErrorMacro("The interactor must have a render window before the widget is enabled");
    return;
  }
  auto* shown = this->GetReflectionProbeRepresentation();
  if (enabling == 0 && this->Enabled != 0 && shown != nullptr) {
    shown->EndWidgetInteraction(nullptr);
    this->Finish();
  }
  this->Superclass::SetEnabled(enabling);
  if (this->Enabled == 0 && shown != nullptr) {
    shown->SetRenderer(nullptr);
  }
}

void vtkReflectionProbeWidget::SetCursor(int state) {
  this->RequestCursorShape(state == vtkReflectionProbeRepresentation::Outside ? VTK_CURSOR_DEFAULT : VTK_CURSOR_HAND);
}

void vtkReflectionProbeWidget::TakeModifiers() {
  auto* shown = this->GetReflectionProbeRepresentation();
  if (!this->ModifierKeys) {
    return;
  }
  shown->SetFine(this->Interactor->GetShiftKey() != 0);
  shown->SetSnapping(this->Interactor->GetControlKey() != 0);
  shown->SetSymmetric(this->Interactor->GetAltKey() != 0);
}

void vtkReflectionProbeWidget::HoverAt(int x, int y) {
  auto* shown = this->GetReflectionProbeRepresentation();
  if (this->CurrentRenderer != nullptr && this->CurrentRenderer->IsInViewport(x, y) != 0) {
    shown->ComputeInteractionState(x, y);
  } else {
    shown->Highlight(0);
  }
  if (shown->GetNeedToRender() == 0) {
    return;
  }
  shown->NeedToRenderOff();
  if (this->ManagesCursor != 0) {
    this->SetCursor(shown->GetInteractionState());
  }
  this->Render();
}

void vtkReflectionProbeWidget::SelectAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkReflectionProbeWidget*>(widget);
  auto* shown = self->GetReflectionProbeRepresentation();
  const int* at = self->Interactor->GetEventPosition();
  if (self->Active || self->CurrentRenderer == nullptr || self->CurrentRenderer->IsInViewport(at[0], at[1]) == 0) {
    return;
  }
  self->TakeModifiers();
  double place[2] = {static_cast<double>(at[0]), static_cast<double>(at[1])};
  shown->StartWidgetInteraction(place);
  if (!shown->GetDragging()) {
    return;
  }
  self->Active = true;
  self->GrabFocus(self->EventCallbackCommand);
  self->EventCallbackCommand->SetAbortFlag(1);
  self->StartInteraction();
  self->InvokeEvent(vtkCommand::StartInteractionEvent, nullptr);
  self->Render();
}

void vtkReflectionProbeWidget::MoveAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkReflectionProbeWidget*>(widget);
  auto* shown = self->GetReflectionProbeRepresentation();
  const int* at = self->Interactor->GetEventPosition();
  if (!self->Active) {
    self->HoverAt(at[0], at[1]);
    return;
  }
  self->EventCallbackCommand->SetAbortFlag(1);
  if (!shown->GetDragging()) {
    self->Finish();
    return;
  }
  self->TakeModifiers();
  double place[2] = {static_cast<double>(at[0]), static_cast<double>(at[1])};
  const vtkMTimeType before = shown->GetMTime();
  shown->WidgetInteraction(place);
  if (shown->GetMTime() == before) {
    return;  // still within a click, or no further movement
  }
  self->InvokeEvent(vtkCommand::InteractionEvent, nullptr);
  self->Render();
}

void vtkReflectionProbeWidget::EndSelectAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkReflectionProbeWidget*>(widget);
  if (!self->Active) {
    return;
  }
  self->EventCallbackCommand->SetAbortFlag(1);
  self->GetReflectionProbeRepresentation()->EndWidgetInteraction(nullptr);
  self->Finish();
}

void vtkReflectionProbeWidget::CancelAction(vtkAbstractWidget* widget) {
  auto* self = static_cast<vtkReflectionProbeWidget*>(widget);
  if (!self->Active) {
    return;
  }
  self->EventCallbackCommand->SetAbortFlag(1);
  self->GetReflectionProbeRepresentation()->CancelInteraction();
  self->InvokeEvent(vtkCommand::InteractionEvent, nullptr);
  self->Finish();
}

void vtkReflectionProbeWidget::Finish() {
  if (!this->Active) {
    return;
  }
  this->Active = false;
  this->ReleaseFocus();
  this->EndInteraction();
  this->InvokeEvent(vtkCommand::EndInteractionEvent, nullptr);
  this->Render();
}

void vtkReflectionProbeWidget::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ModifierKeys: " << this->ModifierKeys << "\n";
  os << indent << "Probe: " << this->GetProbe() << "\n";
}
