#include "filters/vtk/charts/pareto_chart.h"

#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkPlotPoints.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "filters/core/base/number_text.h"
#include "filters/vtk/charts/vtkParetoLabels.h"
#include "filters/vtk/gl/window_pixels.h"

namespace boxprobe {

namespace {

/// Points of one kind, as logarithms, with names for tooltips.
vtkSmartPointer<vtkTable> tableOf(const std::vector<ParetoPoint>& points) {
  vtkNew<vtkDoubleArray> x, y;
  vtkNew<vtkStringArray> names;
  x->SetName("cost");
  y->SetName("error");
  names->SetName("name");
  for (const ParetoPoint& p : points) {
    x->InsertNextValue(std::log10(p.cost));
    y->InsertNextValue(std::log10(p.error));
    char text[160];
    std::snprintf(text, sizeof(text), "%.100s: %.2f x, error %.4f", p.label.c_str(), p.cost, p.error);
    names->InsertNextValue(text);
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(x);
  table->AddColumn(y);
  table->AddColumn(names);
  return table;
}

struct Look {
  const char* name;
  int marker;
  float size;
  unsigned char color[3];
};

void addPoints(vtkChartXY* chart, const std::vector<ParetoPoint>& points, const Look& look) {
  if (points.empty()) return;
  const auto table = tableOf(points);
  vtkNew<vtkPlotPoints> plot;
  plot->SetInputData(table, 0, 1);
  plot->SetIndexedLabels(vtkStringArray::SafeDownCast(table->GetColumn(2)));
  plot->SetTooltipLabelFormat("%i");
  plot->SetLabel(look.name);
  plot->SetMarkerStyle(look.marker);
  plot->SetMarkerSize(look.size);
  plot->SetColor(look.color[0], look.color[1], look.color[2], 255);
  chart->AddPlot(plot);
}

std::vector<ParetoPoint> frontOf(const std::vector<ParetoPoint>& points) {
  std::vector<ParetoPoint> front;
  for (const ParetoPoint& p : points) {
    if (p.onParetoFront) front.push_back(p);
  }
  std::sort(front.begin(), front.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  return front;
}

void addFrontLine(vtkChartXY* chart, const std::vector<ParetoPoint>& front) {
  if (front.size() < 2) return;
  vtkNew<vtkPlotLine> line;
  line->SetInputData(tableOf(front), 0, 1);
  line->SetLabel("Pareto front");
  line->SetColor(214, 96, 32, 255);
  line->SetWidth(2.0f);
  line->SetMarkerStyle(vtkPlotPoints::NONE);
  chart->AddPlot(line);
}

/// Ticks at round numbers within a range of logarithms: more ticks per decade if it spans few decades.
void setAxis(vtkAxis* axis, double low, double high, const std::string& title) {
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  const double air = 0.06 * std::max(high - low, 0.3);
  low -= air;
  high += air;
  for (int power = static_cast<int>(std::floor(low)) - 1; power <= static_cast<int>(std::ceil(high)); ++power) {
    for (const double digit : {1.0, 1.2, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0}) {
      const bool coarse = digit == 1.0 || digit == 2.0 || digit == 5.0;
      const double at = std::log10(digit) + power;
      if (at < low || at > high || (!coarse && high - low > 1.2)) continue;
      positions->InsertNextValue(at);
      char text[32];
      std::snprintf(text, sizeof(text), "%g", digit * std::pow(10.0, power));
      labels->InsertNextValue(text);
    }
  }
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(low, high);
  axis->SetCustomTickPositions(positions, labels);
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(15);
  axis->GetTitleProperties()->BoldOff();
  axis->GetLabelProperties()->SetFontSize(13);
  axis->GetGridPen()->SetColor(225, 225, 228, 255);
}

std::vector<ParetoPoint> drawable(const std::vector<ParetoPoint>& points) {
  std::vector<ParetoPoint> result;
  for (const ParetoPoint& p : points) {
    if (p.cost > 0.0 && p.error > 0.0 && std::isfinite(p.cost) && std::isfinite(p.error)) result.push_back(p);
  }
  return result;
}

}  // namespace

void showFrontChart(vtkContextScene* scene, const std::vector<ParetoPoint>& all, const FrontChartText& text) {
  scene->ClearItems();
  const std::vector<ParetoPoint> points = drawable(all);
  vtkNew<vtkChartXY> chart;
  chart->SetTitle(text.title);
  chart->GetTitleProperties()->SetFontSize(17);
  double low[2] = {0.0, -1.0}, high[2] = {0.0, -1.0};
  std::vector<ParetoPoint> ours, published, current;
  const std::vector<ParetoPoint> front = frontOf(points);
  std::vector<vtkParetoLabels::Label> labels;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ParetoPoint& p = points[i];
    const double at[2] = {std::log10(p.cost), std::log10(p.error)};
    for (int k = 0; k < 2; ++k) {
      low[k] = i == 0 ? at[k] : std::min(low[k], at[k]);
      high[k] = i == 0 ? at[k] : std::max(high[k], at[k]);
    }
    (p.ours ? ours : published).push_back(p);
    if (!text.current.empty() && p.label == text.current) current.push_back(p);
    labels.push_back({at[0], at[1], p.label, p.onParetoFront || p.label == text.current});
  }
  // Labels must not cover the line between two neighbours on the front.
  for (std::size_t i = 1; i < front.size(); ++i) {
    for (int k = 1; k < 40; ++k) {
      const auto between = [&](double a, double b) { return std::log10(a) + k / 40.0 * std::log10(b / a); };
      labels.push_back({between(front[i - 1].cost, front[i].cost), between(front[i - 1].error, front[i].error), {}});
    }
  }
  setAxis(chart->GetAxis(vtkAxis::BOTTOM), low[0], high[0], text.costAxis);
  setAxis(chart->GetAxis(vtkAxis::LEFT), low[1], high[1], text.errorAxis);
  addFrontLine(chart, front);
  addPoints(chart, current, {"current choice", vtkPlotPoints::CIRCLE, 22.0f, {250, 205, 60}});
  addPoints(chart, published, {"published", vtkPlotPoints::CIRCLE, 10.0f, {90, 98, 112}});
  addPoints(chart, ours, {"this project's own", vtkPlotPoints::DIAMOND, 12.0f, {30, 110, 190}});
  chart->SetShowLegend(true);
  // The area below and left of the front is always empty.
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::LEFT);
  chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::BOTTOM);
  scene->AddItem(chart);
  vtkNew<vtkParetoLabels> names;
  names->SetChart(chart);
  names->SetLabels(std::move(labels));
  scene->AddItem(names);
}

ImageRgba8 frontChartPicture(const std::vector<ParetoPoint>& points, const FrontChartText& text,
                             vtkOpenGLRenderWindow* window) {
  vtkNew<vtkContextView> view;
  view->SetRenderWindow(window);
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  showFrontChart(view->GetScene(), points, text);
  // The position of the axes is known after a first frame.
  window->Render();
  window->Render();
  ImageRgba8 picture = windowPixels(window);
  view->GetScene()->ClearItems();
  view->GetRenderer()->ReleaseGraphicsResources(window);
  window->RemoveRenderer(view->GetRenderer());
  return picture;
}

ImageRgba8 frontChartPicture(const std::vector<ParetoPoint>& points, const FrontChartText& text, int width,
                             int height) {
  const auto window =
      vtkSmartPointer<vtkOpenGLRenderWindow>::Take(vtkOpenGLRenderWindow::SafeDownCast(vtkRenderWindow::New()));
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  return frontChartPicture(points, text, window);
}

}  // namespace boxprobe
