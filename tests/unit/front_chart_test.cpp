// The chart of run time against error as its items hold it: axes with ticks at round numbers, each point in the plot of
// its kind, the front from left to right. Expected numbers are written out, not computed by the chart's formulas.
#include <gtest/gtest.h>
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPlot.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cmath>
#include <limits>

#include "filters/vtk/charts/pareto_chart.h"

namespace boxprobe {
namespace {

ParetoPoint point(const std::string& label, double cost, double error, bool ours = false) {
  ParetoPoint made;
  made.id = made.label = label;
  made.cost = cost;
  made.error = error;
  made.ours = ours;
  return made;
}

struct Chart {
  explicit Chart(const std::vector<ParetoPoint>& points, const FrontChartText& text = {}) {
    showFrontChart(scene, points, text);
    for (unsigned int i = 0; i < scene->GetNumberOfItems(); ++i) {
      if (auto* found = vtkChartXY::SafeDownCast(scene->GetItem(i))) chart = found;
    }
  }

  std::vector<std::string> ticks(int axis) const {
    std::vector<std::string> labels;
    vtkStringArray* array = chart->GetAxis(axis)->GetTickLabels();
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i) labels.push_back(array->GetValue(i));
    return labels;
  }

  /// Cost and error of the points of a plot.
  std::vector<std::pair<double, double>> plot(const std::string& name) const {
    std::vector<std::pair<double, double>> points;
    for (vtkIdType i = 0; i < chart->GetNumberOfPlots(); ++i) {
      if (chart->GetPlot(i)->GetLabel() != name) continue;
      vtkTable* table = chart->GetPlot(i)->GetInput();
      for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row) {
        const auto value = [&](int column) { return std::pow(10.0, table->GetValue(row, column).ToDouble()); };
        points.emplace_back(value(0), value(1));
      }
    }
    return points;
  }

  vtkNew<vtkContextScene> scene;
  vtkChartXY* chart = nullptr;
};

void expectPoints(const std::vector<std::pair<double, double>>& found,
                  const std::vector<std::pair<double, double>>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_NEAR(found[i].first, wanted[i].first, 1e-9 * wanted[i].first) << i;
    EXPECT_NEAR(found[i].second, wanted[i].second, 1e-9 * wanted[i].second) << i;
  }
}

using Labels = std::vector<std::string>;

TEST(FrontChart, TicksAreRoundNumbersOfTheRangeAndFewerOfAWideOne) {
  const Chart narrow({point("a", 1.1, 0.031), point("b", 2.9, 0.19)});
  EXPECT_EQ(narrow.ticks(vtkAxis::BOTTOM), (Labels{"1.2", "1.5", "2", "3"}));
  EXPECT_EQ(narrow.ticks(vtkAxis::LEFT), (Labels{"0.03", "0.04", "0.05", "0.07", "0.1", "0.12", "0.15", "0.2"}));
  const Chart wide({point("a", 0.9, 0.0021), point("b", 41.0, 0.6)});
  EXPECT_EQ(wide.ticks(vtkAxis::BOTTOM), (Labels{"1", "2", "5", "10", "20", "50"}));
  EXPECT_EQ(wide.ticks(vtkAxis::LEFT), (Labels{"0.002", "0.005", "0.01", "0.02", "0.05", "0.1", "0.2", "0.5"}));
  vtkAxis* bottom = wide.chart->GetAxis(vtkAxis::BOTTOM);
  EXPECT_LT(bottom->GetMinimum(), std::log10(0.9)) << "a point has air around it";
  EXPECT_GT(bottom->GetMaximum(), std::log10(41.0));
}

TEST(FrontChart, EachPointIsInThePlotOfItsKind) {
  FrontChartText text;
  text.current = "d";
  std::vector<ParetoPoint> points = {point("d", 3.0, 0.02, true), point("a", 1.0, 0.3), point("c", 2.5, 0.35),
                                     point("b", 1.7, 0.07, true)};
  markParetoFront(points);
  // No logarithm shows these.
  for (const ParetoPoint& off : {point("none", 0.0, 0.1), point("perfect", 2.0, 0.0),
                                 point("endless", std::numeric_limits<double>::infinity(), 0.1)}) {
    points.push_back(off);
    points.back().onParetoFront = true;
  }
  const Chart chart(points, text);
  expectPoints(chart.plot("Pareto front"), {{1.0, 0.3}, {1.7, 0.07}, {3.0, 0.02}});
  expectPoints(chart.plot("published"), {{1.0, 0.3}, {2.5, 0.35}});
  expectPoints(chart.plot("this project's own"), {{3.0, 0.02}, {1.7, 0.07}});
  expectPoints(chart.plot("current choice"), {{3.0, 0.02}});
}

TEST(FrontChart, OfNothingIsEmpty) {
  const Chart chart({});
  ASSERT_NE(chart.chart, nullptr);
  EXPECT_EQ(chart.chart->GetNumberOfPlots(), 0);
}

}  // namespace
}  // namespace boxprobe
