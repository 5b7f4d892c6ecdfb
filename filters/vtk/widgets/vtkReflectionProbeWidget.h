/**
 * @class vtkReflectionProbeWidget
 * @brief bounds, origin, influence, blend distances and orientation of a vtkReflectionProbe, edited with the mouse
 *
 *     vtkNew<vtkReflectionProbeWidget> widget;
 *     widget->SetInteractor(interactor);
 *     widget->SetProbe(probe);
 *     widget->On();
 *
 * The left button drags the handles of vtkReflectionProbeRepresentation, which are selected by its Mode. Shift slows
 * the drag down to a tenth, Control snaps to the wall under the pointer or to a grid, Alt also moves the opposite face,
 * Escape restores the probe. Events that do not hit a handle are passed to the interactor's style.
 *
 * Invokes StartInteractionEvent, InteractionEvent after each change of the probe, and EndInteractionEvent. If the probe
 * belongs to a vtkReflectionProbes, the next frame shows the change; only a moved origin or a rotation needs a capture.
 * Removing the probe or disabling the widget ends a drag.
 */
#pragma once

#include <vtkAbstractWidget.h>

#include "filters/core/base/export.h"

class vtkReflectionProbe;
class vtkReflectionProbeRepresentation;

class BOXPROBE_EXPORT vtkReflectionProbeWidget : public vtkAbstractWidget {
 public:
  static vtkReflectionProbeWidget* New();
  // clang-format off
  vtkTypeMacro(vtkReflectionProbeWidget, vtkAbstractWidget)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The representation's probe. Null: nothing is shown. */
  void SetProbe(vtkReflectionProbe* probe);
  vtkReflectionProbe* GetProbe();
  ///@}
  ///@{
  /** Created when first needed. */
  void SetRepresentation(vtkReflectionProbeRepresentation* representation);
  vtkReflectionProbeRepresentation* GetReflectionProbeRepresentation();
  void CreateDefaultRepresentation() override;
  ///@}
  ///@{
  /** Do Shift, Control and Alt set Fine, Snapping and Symmetric of the representation? On by default; off: the program
   * sets them. */
  vtkSetMacro(ModifierKeys, bool)
  vtkGetMacro(ModifierKeys, bool)
  vtkBooleanMacro(ModifierKeys, bool)
  ///@}
  /** Enabling it without an interactor that has a window is an error, and it stays off. Disabling it ends a drag. */
  void SetEnabled(int enabling) override;
  // clang-format on

 protected:
  vtkReflectionProbeWidget();
  ~vtkReflectionProbeWidget() override;

  void SetCursor(int state) override;

  bool ModifierKeys = true;

 private:
  vtkReflectionProbeWidget(const vtkReflectionProbeWidget&) = delete;
  void operator=(const vtkReflectionProbeWidget&) = delete;

  static void SelectAction(vtkAbstractWidget* widget);
  static void MoveAction(vtkAbstractWidget* widget);
  static void EndSelectAction(vtkAbstractWidget* widget);
  static void CancelAction(vtkAbstractWidget* widget);
  void TakeModifiers();
  void HoverAt(int x, int y);
  /** Ends the interaction started by StartInteractionEvent. */
  void Finish();

  bool Active = false;
};
