// Identifies glass props and sorts them: they are drawn after everything behind them.
#pragma once

#include <vector>

class vtkCamera;
class vtkProp;

namespace boxprobe {

/// Is the prop drawn as glass now: a material that transmits light, lit by probes and sky?
bool isGlass(vtkProp* prop);

/// `props` with glass at the end, farthest first, because glass is blended over what is there.
std::vector<vtkProp*> glassLast(const std::vector<vtkProp*>& props, vtkCamera* camera);

}  // namespace boxprobe
