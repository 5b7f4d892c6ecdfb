// A chart of run time against error: published techniques and this project's own with different marks, the Pareto front
// as a line, and a label for each point.
#pragma once

#include <string>
#include <vector>

#include "filters/core/picture/pareto_front.h"
#include "filters/core/scene/model.h"

class vtkContextScene;
class vtkOpenGLRenderWindow;

namespace boxprobe {

struct FrontChartText {
  std::string title;
  std::string errorAxis = "Error (tone-mapped RMSE)";
  std::string costAxis = "Frame time relative to plain box projection";
  std::string current;  ///< label of a point to highlight, empty: none
};

/// Adds the chart to the scene of a context view, replacing that of an earlier call. Points without a positive cost and
/// error are left out: both axes are logarithmic.
void showFrontChart(vtkContextScene* scene, const std::vector<ParetoPoint>& points, const FrontChartText& text);

/// The chart as a picture with the size of `window`, which may be hidden and is restored afterwards.
ImageRgba8 frontChartPicture(const std::vector<ParetoPoint>& points, const FrontChartText& text,
                             vtkOpenGLRenderWindow* window);
/// The same, drawn in a hidden window of its own. Needs a display.
ImageRgba8 frontChartPicture(const std::vector<ParetoPoint>& points, const FrontChartText& text, int width, int height);

}  // namespace boxprobe
