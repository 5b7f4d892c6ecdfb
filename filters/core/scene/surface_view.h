// Quantities by which the debug view colours surfaces, as a table. They are computed in the shader
// (shaders/gpu/surface_view.glsl) and, for saved data and tests, from the explanation of a pixel (surface_value.h).
// Combo box, command line and tests iterate these rows.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace boxprobe {

enum class ViewKind {
  Picture,   ///< no debug view
  Scalar,    ///< a number, through a colour map, with a scalar bar
  Color,     ///< three numbers, shown as red, green, blue
  Light,     ///< radiance, shown with exposure and tone as the picture is
  Category,  ///< one colour for each of a few values
};

struct SurfaceViewRow {
  std::string_view id;
  std::string_view label;
  std::string_view unit;  ///< "" for a pure number
  std::string_view help;  ///< one line
  ViewKind kind;
  double low, high;  ///< range shown by default; equal: from the scene's size
};

/// Row 0 is the ordinary picture.
const std::vector<SurfaceViewRow>& surfaceViews();
/// Index of the row of that id.
std::optional<int> findSurfaceView(std::string_view id);

struct SurfaceViewSettings {
  int view = 0;
  std::optional<double> low, high;  ///< a fixed range; empty: the row's
  bool operator==(const SurfaceViewSettings& o) const { return view == o.view && low == o.low && high == o.high; }
};

}  // namespace boxprobe
