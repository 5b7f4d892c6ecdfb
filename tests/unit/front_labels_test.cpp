// The names beside the points of the chart of run time against error, as they are painted onto a device that only
// remembers: their places, the lines that lead to them, and how the plots look.
#include <gtest/gtest.h>
#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextDevice2D.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkStringArray.h>
#include <vtkTextProperty.h>
#include <vtkVersionMacros.h>

#include <cmath>

#include "filters/vtk/charts/pareto_chart.h"
#include "filters/vtk/charts/vtkParetoLabels.h"
#include "tests/support/kept_values.h"

namespace boxprobe {
namespace {

using test::keptNumbers;

ParetoPoint point(const std::string& label, double cost, double error, bool ours = false) {
  ParetoPoint made;
  made.id = made.label = label;
  made.cost = cost;
  made.error = error;
  made.ours = ours;
  return made;
}

// The signatures of a device are others in later versions of VTK.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)

struct Written {
  std::string text;
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
  bool bold = false;
};
constexpr float kLetter = 7.0f, kTall = 11.0f;

/// Letters of one size.
class Memory : public vtkContextDevice2D {
 public:
  static Memory* New() { VTK_STANDARD_NEW_BODY(Memory); }
  vtkTypeMacro(Memory, vtkContextDevice2D) void DrawPoly(float* p, int n, unsigned char*, int) override {
    this->DrawLines(p, n);
  }
  void DrawLines(float* p, int n, unsigned char* = nullptr, int = 0) override {
    std::string line = "line";
    for (int i = 0; i < 2 * n; ++i) line += keptNumbers(p[i]);
    this->Lines.push_back(line + " pen" +
                          keptNumbers(this->Pen->GetWidth(), this->Pen->GetColor()[0], this->Pen->GetColor()[2],
                                      this->Pen->GetLineType()));
  }
  void DrawPoints(float*, int, unsigned char*, int) override {}
  void DrawPointSprites(vtkImageData*, float*, int, unsigned char*, int) override {}
  void DrawMarkers(int, bool, float*, int, unsigned char*, int) override {}
  void DrawColoredPolygon(float*, int, unsigned char*, int) override {}
  void DrawEllipseWedge(float, float, float, float, float, float, float, float) override {}
  void DrawEllipticArc(float, float, float, float, float, float) override {}
  void DrawString(float* p, const vtkStdString& text) override {
    const double* c = this->TextProp->GetColor();
    this->Strings.push_back(
        {text, p[0], p[1], kLetter * static_cast<double>(text.size()), kTall, this->TextProp->GetBold() != 0});
    this->Lines.push_back("name '" + text + "' at" + keptNumbers(p[0], p[1]) + " text" +
                          keptNumbers(this->TextProp->GetBold(), this->TextProp->GetFontSize(), c[0], c[2],
                                      this->TextProp->GetFontFamily(), this->TextProp->GetJustification(),
                                      this->TextProp->GetVerticalJustification()));
  }
  void ComputeStringBounds(const vtkStdString& text, float bounds[4]) override {
    bounds[0] = bounds[1] = 0.0f;
    bounds[2] = kLetter * static_cast<float>(text.size());
    bounds[3] = kTall;
  }
  void DrawString(float*, const vtkUnicodeString&) override {}
  void ComputeStringBounds(const vtkUnicodeString&, float bounds[4]) override { std::fill(bounds, bounds + 4, 0.0f); }
  void ComputeJustifiedStringBounds(const char* text, float bounds[4]) override {
    this->ComputeStringBounds(vtkStdString(text), bounds);
  }
  void DrawMathTextString(float*, const vtkStdString&) override {}
  void DrawImage(float*, float, vtkImageData*) override {}
  void DrawImage(const vtkRectf&, vtkImageData*) override {}
  void DrawPolyData(float[2], float, vtkPolyData*, vtkUnsignedCharArray*, int) override {}
  void SetColor4(unsigned char*) override {}
  void SetTexture(vtkImageData*, int) override {}
  void SetPointSize(float) override {}
  void SetLineWidth(float) override {}
  void SetLineType(int) override {}
  void SetMatrix(vtkMatrix3x3*) override {}
  void GetMatrix(vtkMatrix3x3*) override {}
  void MultiplyMatrix(vtkMatrix3x3*) override {}
  void PushMatrix() override {}
  void PopMatrix() override {}
  void SetClipping(int*) override {}
  void EnableClipping(bool) override {}

  std::vector<std::string> Lines;
  std::vector<Written> Strings;
};

struct Painted {
  explicit Painted(std::vector<vtkParetoLabels::Label> names) {
    // An area of 60 to 460 across and 40 to 340 up, for 0 to 2 and -3 to 0.
    vtkAxis* bottom = chart->GetAxis(vtkAxis::BOTTOM);
    vtkAxis* left = chart->GetAxis(vtkAxis::LEFT);
    bottom->SetPoint1(60.0f, 40.0f);
    bottom->SetPoint2(460.0f, 40.0f);
    left->SetPoint1(60.0f, 40.0f);
    left->SetPoint2(60.0f, 340.0f);
    bottom->SetRange(0.0, 2.0);
    left->SetRange(-3.0, 0.0);
    labels->SetChart(chart);
    labels->SetLabels(std::move(names));
    painter->Begin(device);
    EXPECT_TRUE(labels->Paint(painter));
    painter->End();
  }
  vtkNew<vtkChartXY> chart;
  vtkNew<vtkParetoLabels> labels;
  vtkNew<Memory> device;
  vtkNew<vtkContext2D> painter;
};

TEST(FrontLabels, StandBesideTheirPointsAndOnNothingElse) {
  const Painted apart({{0.5, -2.0, "left", false}, {1.5, -1.0, "right one", true}, {1.0, -0.5, "", true}});
  ASSERT_EQ(apart.device->Strings.size(), 2u);
  // The important one first. Right of its point: 7 of the mark and 1 more, 2 within the label's own space.
  EXPECT_EQ(apart.device->Strings[0].text, "right one");
  EXPECT_TRUE(apart.device->Strings[0].bold);
  EXPECT_NEAR(apart.device->Strings[0].x, 360.0 + 8.0 + 2.0, 1e-3);
  EXPECT_NEAR(apart.device->Strings[0].y, 240.0 - 7.5 + 1.0, 1e-3);
  EXPECT_EQ(apart.device->Strings[1].text, "left");
  EXPECT_FALSE(apart.device->Strings[1].bold);
  EXPECT_NEAR(apart.device->Strings[1].x, 160.0 + 10.0, 1e-3);
  EXPECT_NEAR(apart.device->Strings[1].y, 140.0 - 6.5, 1e-3);

  // Crowded: no two cover each other, nor a point of another, and all are within the axes.
  std::vector<vtkParetoLabels::Label> names;
  for (int i = 0; i < 14; ++i) {
    names.push_back({1.84 + 0.011 * (i % 5) - 0.03 * (i / 5), -0.2 - 0.041 * (i % 3) - 0.05 * (i / 5),
                     "name " + std::to_string(i * i * i), i % 4 == 1});
  }
  const Painted crowd(names);
  const std::vector<Written>& all = crowd.device->Strings;
  ASSERT_EQ(all.size(), 14u);
  for (std::size_t a = 0; a < all.size(); ++a) {
    EXPECT_GE(all[a].x, 60.0) << all[a].text;
    EXPECT_GE(all[a].y, 40.0) << all[a].text;
    EXPECT_LE(all[a].x + all[a].width, 460.0) << all[a].text;
    EXPECT_LE(all[a].y + all[a].height, 340.0) << all[a].text;
    for (std::size_t b = 0; b < a; ++b) {
      const bool apartAcross = all[a].x + all[a].width <= all[b].x || all[b].x + all[b].width <= all[a].x;
      const bool apartUp = all[a].y + all[a].height <= all[b].y || all[b].y + all[b].height <= all[a].y;
      EXPECT_TRUE(apartAcross || apartUp) << all[a].text << " on " << all[b].text;
    }
  }
  std::vector<std::string> lines = {"-- crowded"};
  lines.insert(lines.end(), crowd.device->Lines.begin(), crowd.device->Lines.end());
  const Painted corners({{0.01, -2.99, "low left", false},
                         {1.99, -2.98, "low right", true},
                         {0.02, -0.01, "high left", false},
                         {1.98, -0.02, "high right", false},
                         {1.0, -1.5, "", false},
                         {0.99, -1.5, "over a line", false}});
  lines.emplace_back("-- in the corners");
  lines.insert(lines.end(), corners.device->Lines.begin(), corners.device->Lines.end());
  test::expectKeptValues("unit/values/front_labels.txt", lines);
}

TEST(FrontLabels, OfNoChartAreNotPainted) {
  vtkNew<vtkParetoLabels> labels;
  labels->SetLabels({{0.5, -2.0, "left", false}});
  vtkNew<Memory> device;
  vtkNew<vtkContext2D> painter;
  painter->Begin(device);
  EXPECT_TRUE(labels->Paint(painter));
  painter->End();
  EXPECT_TRUE(device->Lines.empty());
}

#endif

TEST(FrontChart, LooksByKind) {
  FrontChartText text;
  text.title = "a title";
  text.costAxis = "time";
  text.errorAxis = "error";
  text.current = "d";
  std::vector<ParetoPoint> points = {point("a", 1.0, 0.3), point("b", 2.0, 0.1, true), point("d", 4.0, 0.05)};
  markParetoFront(points);
  vtkNew<vtkContextScene> scene;
  showFrontChart(scene, points, text);
  ASSERT_EQ(scene->GetNumberOfItems(), 2u);
  auto* chart = vtkChartXY::SafeDownCast(scene->GetItem(0));
  ASSERT_NE(chart, nullptr);
  EXPECT_NE(vtkParetoLabels::SafeDownCast(scene->GetItem(1)), nullptr);
  EXPECT_EQ(chart->GetTitle(), "a title");
  EXPECT_EQ(chart->GetTitleProperties()->GetFontSize(), 17);
  EXPECT_TRUE(chart->GetShowLegend());
  EXPECT_EQ(chart->GetLegend()->GetHorizontalAlignment(), vtkChartLegend::LEFT);
  EXPECT_EQ(chart->GetLegend()->GetVerticalAlignment(), vtkChartLegend::BOTTOM);
  const std::vector<std::pair<int, std::string>> axes = {{vtkAxis::BOTTOM, "time"}, {vtkAxis::LEFT, "error"}};
  for (const auto& [which, title] : axes) {
    vtkAxis* axis = chart->GetAxis(which);
    EXPECT_EQ(axis->GetTitle(), title);
    EXPECT_EQ(axis->GetBehavior(), vtkAxis::FIXED);
    EXPECT_EQ(axis->GetTitleProperties()->GetFontSize(), 15);
    EXPECT_EQ(axis->GetTitleProperties()->GetBold(), 0);
    EXPECT_EQ(axis->GetLabelProperties()->GetFontSize(), 13);
    EXPECT_EQ(axis->GetGridPen()->GetColorObject().GetData()[0], 225);
  }
  // Six hundredths of the range on either side.
  vtkAxis* bottom = chart->GetAxis(vtkAxis::BOTTOM);
  EXPECT_NEAR(bottom->GetMinimum(), -0.06 * std::log10(4.0), 1e-9);
  EXPECT_NEAR(bottom->GetMaximum(), 1.06 * std::log10(4.0), 1e-9);
  struct Look {
    std::string label;
    int marker;
    float size;
    int red, green, blue;
  };
  const std::vector<Look> looks = {{"Pareto front", vtkPlotPoints::NONE, 0.0f, 214, 96, 32},
                                   {"current choice", vtkPlotPoints::CIRCLE, 22.0f, 250, 205, 60},
                                   {"published", vtkPlotPoints::CIRCLE, 10.0f, 90, 98, 112},
                                   {"this project's own", vtkPlotPoints::DIAMOND, 12.0f, 30, 110, 190}};
  ASSERT_EQ(chart->GetNumberOfPlots(), 4);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    auto* plot = vtkPlotPoints::SafeDownCast(chart->GetPlot(static_cast<vtkIdType>(i)));
    ASSERT_NE(plot, nullptr) << i;
    EXPECT_EQ(plot->GetLabel(), looks[i].label);
    EXPECT_EQ(plot->GetMarkerStyle(), looks[i].marker) << i;
    const unsigned char* color = plot->GetPen()->GetColor();
    EXPECT_EQ(color[0], looks[i].red) << i;
    EXPECT_EQ(color[1], looks[i].green) << i;
    EXPECT_EQ(color[2], looks[i].blue) << i;
    if (i == 0) {
      EXPECT_EQ(plot->GetWidth(), 2.0f);
      continue;
    }
    EXPECT_EQ(plot->GetMarkerSize(), looks[i].size) << i;
    EXPECT_EQ(plot->GetTooltipLabelFormat(), "%i") << i;
  }
  EXPECT_EQ(chart->GetPlot(3)->GetIndexedLabels()->GetValue(0), "b: 2.00 x, error 0.1000");
}

}  // namespace
}  // namespace boxprobe
