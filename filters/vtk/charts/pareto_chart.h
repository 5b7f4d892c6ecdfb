// Run time against error as a chart: published techniques and this project's own in different marks, the front drawn
// through those that no other beats, each point named. Called by `boxprobe bench` for front.png and by whoever shows
// the same in a window; knows no benchmark.
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
  std::string current;  ///< label of the point to ring, empty: none
};

/// Adds the chart to a scene of a context view, in place of what an earlier call added. Points without a cost or error
/// above 0 are left out: both axes are logarithmic.
void showFrontChart(vtkContextScene* scene, const std::vector<ParetoPoint>& points, const FrontChartText& text);

/// The chart as a picture as large as `window`, which need not show and is given back as it was.
ImageRgba8 frontChartPicture(const std::vector<ParetoPoint>& points, const FrontChartText& text,
                             vtkOpenGLRenderWindow* window);
/// The same, drawn in a window of its own that does not show. A display must be there.
ImageRgba8 frontChartPicture(const std::vector<ParetoPoint>& points, const FrontChartText& text, int width, int height);

}  // namespace boxprobe
