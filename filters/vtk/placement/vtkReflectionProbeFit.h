/**
 * @class vtkReflectionProbeFit
 * @brief fits boxes to what a renderer shows, and finds places for probes
 *
 *     vtkNew<vtkReflectionProbeFit> fit;
 *     fit->SetProbes(probes);     // vtkReflectionProbes: its renderer's actors
 *     fit->Place();               // a fitted probe for each room, more where they gain
 *     fit->Fit(probe);            // or: the box of one probe, by what its origin sees
 *
 * Works with the triangles of the actors that vtkReflectionProbes uses, as `boxprobe fit` and `boxprobe place` do with
 * those of a model; needs no OpenGL. Captures leave out actors that probes do not see; light passes through those that
 * are translucent. Actors under other mappers than vtkPolyDataMapper are not looked at. Sizes are in the renderer's
 * units and must suit people where rooms are looked for: metres, or SetMetresPerUnit().
 *
 * Takes seconds on large models. ProgressEvent (double*, 0 to 1); SetAbortFlag() from within ends it and changes
 * nothing.
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
  /** Whose renderer is looked at, and which of its actors. */
  void SetProbes(vtkReflectionProbes* probes);
  vtkReflectionProbes* GetProbes() const;
  ///@}
  ///@{
  /** The axis that points up, 0 to 2 for X to Z; 1 by default. Boxes turn about it. */
  vtkSetClampMacro(UpAxis, int, 0, 2)
  vtkGetMacro(UpAxis, int)
  ///@}
  ///@{
  /** Of the renderer's units. 1 by default. */
  vtkSetClampMacro(MetresPerUnit, double, 1.0e-9, 1.0e9)
  vtkGetMacro(MetresPerUnit, double)
  ///@}
  ///@{
  /** Rays for each fit. 4096 by default. */
  vtkSetClampMacro(NumberOfRays, int, 64, 1 << 20)
  vtkGetMacro(NumberOfRays, int)
  ///@}
  ///@{
  /** May a box turn about the up axis? On by default. */
  vtkSetMacro(Turning, bool)
  vtkGetMacro(Turning, bool)
  vtkBooleanMacro(Turning, bool)
  ///@}
  ///@{
  /** Ends the work that is under way. Cleared when the next begins. */
  vtkSetMacro(AbortFlag, bool)
  vtkGetMacro(AbortFlag, bool)
  ///@}

  /** Bounds and orientation by what the probe's origin sees; the origin stays. True if a better box was found; else
   * the probe is as it was, and GetReport() says why. */
  bool Fit(vtkReflectionProbe* probe);
  /** Adds probes for all rooms, `most` at most, beside those that are there. Returns how many; -1 for an error. */
  int Place(int most = 64);

  /** What was decided, sentences on lines of their own. */
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
