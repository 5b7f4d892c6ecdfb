// What a plugin would hold: probes made and asked, without a window.
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "filters/core/base/version.h"
#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/actors/vtkReflectionProbes.h"
#include "filters/vtk/placement/vtkReflectionProbeFit.h"
#include "filters/vtk/widgets/vtkReflectionProbeWidget.h"

#if BOXPROBE_VERSION_NUMBER < BOXPROBE_VERSION_CHECK(0, 1, 0)
#error "too old"
#endif

extern "C" int countProbes() {
  vtkNew<vtkReflectionProbes> probes;
  vtkNew<vtkReflectionProbe> probe;
  probes->AddProbe(probe);
  vtkNew<vtkRenderer> renderer;  // shows nothing: no room to place a probe in
  probes->SetRenderer(renderer);
  vtkNew<vtkReflectionProbeWidget> widget;
  widget->SetProbe(probe);
  if (widget->GetProbe() != probe) return -1;
  vtkNew<vtkReflectionProbeFit> fit;
  fit->SetProbes(probes);
  return fit->Place() == 0 ? probes->GetNumberOfProbes() : -1;
}
