// The lighting model of surface programs: one value for all draws of a scene, compiled in by the splice.
#pragma once

namespace boxprobe {

enum class LightForm {
  Single,    ///< single scattering between microfacets, lamps and probes with the same exact masking
  Multiple,  ///< the same with multiple scattering added back
  Vtk,       ///< VTK 9.1's lamps, coats and table, for comparisons with VTK's own pictures
};

}  // namespace boxprobe
