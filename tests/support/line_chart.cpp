#include "tests/support/line_chart.h"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkPlot.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

namespace boxprobe::test {

ImageRgba8 lineChart(const std::string& title, const std::string& abscissa, const std::vector<double>& at,
                     const std::vector<Curve>& curves) {
  constexpr int kWidth = 960, kHeight = 480;
  vtkNew<vtkContextView> view;
  vtkRenderWindow* window = view->GetRenderWindow();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(kWidth, kHeight);
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkChartXY> chart;
  chart->SetTitle(title);
  chart->SetShowLegend(true);
  chart->GetAxis(vtkAxis::BOTTOM)->SetTitle(abscissa);
  chart->GetAxis(vtkAxis::LEFT)->SetTitle("");
  for (const Curve& curve : curves) {
    vtkNew<vtkDoubleArray> x, y;
    x->SetName("x");
    y->SetName(curve.name.c_str());
    for (std::size_t i = 0; i < at.size(); ++i) {
      x->InsertNextValue(at[i]);
      y->InsertNextValue(curve.values[i]);
    }
    vtkNew<vtkTable> table;
    table->AddColumn(x);
    table->AddColumn(y);
    vtkPlot* line = chart->AddPlot(vtkChart::LINE);
    line->SetInputData(table, 0, 1);
    line->SetColor(curve.color[0], curve.color[1], curve.color[2], 255);
    line->SetWidth(1.5f);
  }
  view->GetScene()->AddItem(chart);
  window->Render();
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, kWidth - 1, kHeight - 1, 1, pixels, 0);
  ImageRgba8 image{kWidth, kHeight, {}, {}};
  for (int y = kHeight - 1; y >= 0; --y) {
    for (int x = 0; x < kWidth; ++x) {
      const unsigned char* pixel = pixels->GetPointer(3 * (static_cast<vtkIdType>(y) * kWidth + x));
      image.pixels.insert(image.pixels.end(), {pixel[0], pixel[1], pixel[2], 255});
    }
  }
  return image;
}

}  // namespace boxprobe::test
