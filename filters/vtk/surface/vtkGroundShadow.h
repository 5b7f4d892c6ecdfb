/**
 * @class   vtkGroundShadow
 * @brief   a soft shadow on a plane below a scene, blended over display colours
 *
 * Drawn in the window's own frames alone: captures, mirrors and linear pictures name what they draw. Seen from above;
 * a camera below the plane sees nothing of it.
 */
#pragma once

#include <vtkProp.h>

#include <memory>

#include "filters/core/geometry/ground_shadow.h"
#include "filters/vtk/gl/full_screen_pass.h"

class vtkGroundShadow : public vtkProp {
 public:
  static vtkGroundShadow* New();
  vtkTypeMacro(vtkGroundShadow, vtkProp)

      void SetCounters(boxprobe::Counters* counters) {
    this->Counts = counters;
  }
  /** Null or empty: nothing is drawn. */
  void SetShadow(std::shared_ptr<const boxprobe::GroundShadow> shadow);

  /** With what is opaque, since VTK blends the rest in its own ways; to be added after the sky. */
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  double* GetBounds() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  vtkGroundShadow() = default;
  ~vtkGroundShadow() override = default;

 private:
  vtkGroundShadow(const vtkGroundShadow&) = delete;
  void operator=(const vtkGroundShadow&) = delete;

  std::shared_ptr<const boxprobe::GroundShadow> Shadow;
  std::unique_ptr<boxprobe::FullScreenPass> Pass;
  boxprobe::Counters* Counts = nullptr;
  unsigned int Texture = 0;
  double Bounds[6] = {};
  bool Changed = false;
};
