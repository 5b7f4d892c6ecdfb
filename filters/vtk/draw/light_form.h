// Which light a surface's program works out: one value for all draws of a scene. Set by the renderer, compiled in by
// the splice.
#pragma once

namespace boxprobe {

enum class LightForm {
  Single,    ///< one reflection between microfacets, lamps and probes by the same exact masking
  Multiple,  ///< the same, and what further reflections between microfacets bring back
  Vtk,       ///< VTK 9.1's lamps and coats, the table being VTK's: for pictures that are compared with VTK's own
};

}  // namespace boxprobe
