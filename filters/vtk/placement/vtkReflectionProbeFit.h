/**
 * @class vtkReflectionProbeFit
 * @brief fits boxes to what a renderer shows, and finds places for probes
 *
 *     vtkNew<vtkReflectionProbeFit> fit;
 *     fit->SetProbes(probes);     // vtkReflectionProbes: its renderer's actors
 *     fit->Place();               // a fitted probe for each room, more where they gain
 *     fit->Fit(probe);            // or: the box of one probe, by what its origin sees
 *
 * Uses the triangles of the actors of vtkReflectionProbes, as `boxprobe fit` and `boxprobe place` use those of a model;
 * needs no OpenGL. Probes do not see actors that are hidden from them; light passes through translucent ones. Ignores
 * actors with mappers other than vtkPolyDataMapper. To find rooms, sizes must fit people: use metres, or call
 * SetMetresPerUnit().
 *
 * Takes seconds on large models. Invokes ProgressEvent (double*, 0 to 1); calling SetAbortFlag() in an observer ends
 * the work without changes.
 */
#pragma once

#include <vtkObject.h>

#include <memory>
#include <string>

#include "filters/core/base/export.h"

class vtkReflectionProbe;
class vtkReflectionProbes;

class BOXPROBE_EXPORT vtkReflectionProbeFit : public vtkObject {
 public:
  static vtkReflectionProbeFit* New();
  // clang-format off
  vtkTypeMacro(vtkReflectionProbeFit, vtkObject)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Provides the renderer and the choice of actors. */
  void SetProbes(vtkReflectionProbes* probes);
  vtkReflectionProbes* GetProbes() const;
  ///@}
  ///@{
  /** The axis that points up, 0 to 2 for X to Z; 1 by default. Boxes are rotated about it. */
  vtkSetClampMacro(UpAxis, int, 0, 2)
  vtkGetMacro(UpAxis, int)
  ///@}
  ///@{
  /** Length of the renderer's unit in metres. 1 by default. */
  vtkSetClampMacro(MetresPerUnit, double, 1.0e-9, 1.0e9)
  vtkGetMacro(MetresPerUnit, double)
  ///@}
  ///@{
  /** Rays per fit. 4096 by default. */
  vtkSetClampMacro(NumberOfRays, int, 64, 1 << 20)
  vtkGetMacro(NumberOfRays, int)
  ///@}
  ///@{
  /** May boxes be rotated about the up axis? On by default. */
  vtkSetMacro(Turning, bool)
  vtkGetMacro(Turning, bool)
  vtkBooleanMacro(Turning, bool)
  ///@}
  ///@{
  /** Ends the work in progress. Cleared when the next work starts. */
  vtkSetMacro(AbortFlag, bool)
  vtkGetMacro(AbortFlag, bool)
  ///@}

  /** Fits bounds and orientation to what the probe's origin sees; the origin stays. True if a better box was found; else
   * the probe is unchanged, and GetReport() gives the reason. */
  bool Fit(vtkReflectionProbe* probe);
  /** Adds probes for all rooms, at most `most`, and keeps existing ones. Returns how many it added; -1 for an error. */
  int Place(int most = 64);

  /** The decisions, one sentence per line. */
  const char* GetReport() const { return this->Report.c_str(); }
  // clang-format on

 protected:
  vtkReflectionProbeFit();
  ~vtkReflectionProbeFit() override;

  int UpAxis = 1;
  double MetresPerUnit = 1.0;
  int NumberOfRays = 4096;
  bool Turning = true;
  bool AbortFlag = false;
  std::string Report;

 private:
  vtkReflectionProbeFit(const vtkReflectionProbeFit&) = delete;
  void operator=(const vtkReflectionProbeFit&) = delete;

  struct Parts;
  std::unique_ptr<Parts> Inside;
};
