// Which props are glass, and in which order they are drawn: after all that lies behind them. Called by the passes;
// knows no scene.
#pragma once

#include <vector>

class vtkCamera;
class vtkProp;

namespace boxprobe {

/// Is it drawn as glass now: a material that transmits light, lit by probes and sky?
bool isGlass(vtkProp* prop);

/// `props` with glass after all else, farthest first: what it is blended over has to be there.
std::vector<vtkProp*> glassLast(const std::vector<vtkProp*>& props, vtkCamera* camera);

}  // namespace boxprobe
