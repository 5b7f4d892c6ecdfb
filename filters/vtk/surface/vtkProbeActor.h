/**
 * @class   vtkProbeActor
 * @brief   an actor of this program's scenes, lit by reflection probes
 *
 * Has a vtkProbePass among its property keys and prepares it for each draw; its mapper is VTK's own. What surrounds a
 * draw happens here: the passes of glass with their faces, depth and colour masks, and what is left out to find what it
 * costs.
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
  /** Draws `data` by a mapper of VTK's own, which hands the program what the vertices bring for the surface. */
  void SetShape(vtkPolyData* data, std::shared_ptr<const boxprobe::SurfaceMaterial> surface);

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;
  /** A program that has to be another one counts, too. */
  vtkMTimeType GetRedrawMTime() override;

 protected:
  vtkProbeActor();
  ~vtkProbeActor() override;

 private:
  vtkProbeActor(const vtkProbeActor&) = delete;
  void operator=(const vtkProbeActor&) = delete;

  vtkNew<vtkProbePass> Pass;
};
