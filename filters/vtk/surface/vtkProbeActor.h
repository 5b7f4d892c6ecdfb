/**
 * @class   vtkProbeActor
 * @brief   an actor of this program's scenes, lit by reflection probes
 *
 * Has a vtkProbePass among its property keys and prepares it for each draw; its mapper is VTK's own. Controls the state
 * around a draw: the passes of glass with their faces, depth and colour masks, and parts disabled for measurements.
 */
#pragma once

#include <vtkNew.h>
#include <vtkOpenGLActor.h>

#include <memory>

#include "filters/vtk/surface/vtkProbePass.h"

class vtkPolyData;

class vtkProbeActor : public vtkOpenGLActor {
 public:
  static vtkProbeActor* New();
  vtkTypeMacro(vtkProbeActor, vtkOpenGLActor) void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkProbePass* GetPass() const { return this->Pass; }
  /** Draws `data` with a mapper of VTK's own, which passes the surface's vertex attributes to the program. */
  void SetShape(vtkPolyData* data, std::shared_ptr<const boxprobe::SurfaceMaterial> surface);

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;
  /** Includes changes of the program. */
  vtkMTimeType GetRedrawMTime() override;

 protected:
  vtkProbeActor();
  ~vtkProbeActor() override;

 private:
  vtkProbeActor(const vtkProbeActor&) = delete;
  void operator=(const vtkProbeActor&) = delete;

  vtkNew<vtkProbePass> Pass;
};
