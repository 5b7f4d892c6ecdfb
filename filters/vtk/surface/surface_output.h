// The outputs of a surface's program.
#pragma once

namespace boxprobe {

enum class SurfaceOutput {
  Picture,               ///< the colour
  Debug,                 ///< any row of surfaceViews(), with the surface's properties in further attachments
  SpecularSeparate,      ///< the colour, with the sampled reflection in further attachments
  SpecularSeparateNone,  ///< the same for a surface without sampled reflections
  Heights,               ///< the colour, with the height over a planar mirror in another attachment
};

}  // namespace boxprobe
