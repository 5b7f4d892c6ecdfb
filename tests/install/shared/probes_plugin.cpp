// What a plugin would hold: probes made and asked, without a window.
#include <vtkNew.h>

#include "filters/core/base/version.h"
#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/actors/vtkReflectionProbes.h"

#if BOXPROBE_VERSION_NUMBER < BOXPROBE_VERSION_CHECK(0, 1, 0)
#error "too old"
#endif

extern "C" int countProbes() {
  vtkNew<vtkReflectionProbes> probes;
  vtkNew<vtkReflectionProbe> probe;
  probes->AddProbe(probe);
  return probes->GetNumberOfProbes();
}
