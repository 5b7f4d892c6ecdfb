/**
 * @class vtkReflectionProbeWidget
 * @brief bounds, origin, influence, blend distances and orientation of a vtkReflectionProbe, edited with the mouse
 *
 *     vtkNew<vtkReflectionProbeWidget> widget;
 *     widget->SetInteractor(interactor);
 *     widget->SetProbe(probe);
 *     widget->On();
 *
 * The left button drags the handles that vtkReflectionProbeRepresentation shows; which, says its Mode. Shift: a tenth
 * as far. Control: onto the wall under the pointer, or the grid. Alt: the opposite face as well. Escape puts the probe
 * back to where the drag began. Events beside the handles go to the interactor's style.
 *
 * Invokes StartInteractionEvent, InteractionEvent after each change of the probe, and EndInteractionEvent. A probe
 * among those of a vtkReflectionProbes shows the change in the next frame; only a moved origin or a turn is captured
 * again. A drag whose probe is taken away, or whose widget is switched off, ends there.
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
  /** The representation's. Null: nothing is shown. */
  void SetProbe(vtkReflectionProbe* probe);
  vtkReflectionProbe* GetProbe();
  ///@}
  ///@{
  /** Made by itself when it is first needed. */
  void SetRepresentation(vtkReflectionProbeRepresentation* representation);
  vtkReflectionProbeRepresentation* GetReflectionProbeRepresentation();
  void CreateDefaultRepresentation() override;
  ///@}
  ///@{
  /** Shift, Control and Alt set Fine, Snapping and Symmetric of the representation. On by default; off, they are what the
   * program sets. */
  vtkSetMacro(ModifierKeys, bool)
  vtkGetMacro(ModifierKeys, bool)
  vtkBooleanMacro(ModifierKeys, bool)
  ///@}
  /** Without an interactor that has a window, switching it on is an error, and it stays off. Off ends a drag under way. */
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
  /** Ends what began with StartInteractionEvent. */
  void Finish();

  bool Active = false;
};
