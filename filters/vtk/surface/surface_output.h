// What a surface's program writes: chosen by the probe pass, compiled in by the splice. Knows neither.
#pragma once

namespace boxprobe {

enum class SurfaceOutput {
  Picture,               ///< the colour
  Debug,                 ///< any row of surfaceViews(), and what the surface is into further attachments
  SpecularSeparate,      ///< the colour, and what its techniques sample into further attachments
  SpecularSeparateNone,  ///< the same of a surface that keeps nothing apart
  Heights,               ///< the colour, and the height over a planar mirror into another attachment
};

}  // namespace boxprobe
