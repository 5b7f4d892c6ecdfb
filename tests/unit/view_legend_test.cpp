// The legend of each debug view, prop by prop, against view_legend.txt; the range of a view that takes it from the
// scene; and the traced light at a pixel.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkDataArray.h>
#include <vtkLegendBoxActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkScalarsToColors.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "filters/vtk/inspect/shown_view.h"
#include "tests/support/kept_values.h"

namespace boxprobe {
namespace {

using test::keptNumbers;

std::string three(const double* v) {
  return keptNumbers(v[0], v[1], v[2]);
}

std::string textOf(vtkTextProperty* look) {
  return " text" + three(look->GetColor()) +
         keptNumbers(look->GetFontFamily(), look->GetFontSize(), look->GetBold(), look->GetItalic(), look->GetShadow(),
                     look->GetVerticalJustification(), look->GetBackgroundOpacity()) +
         three(look->GetBackgroundColor());
}

std::string lineOf(vtkProp* prop) {
  if (auto* bar = vtkScalarBarActor::SafeDownCast(prop)) {
    vtkScalarsToColors* table = bar->GetLookupTable();
    std::string line = "bar at" +
                       keptNumbers(bar->GetPosition()[0], bar->GetPosition()[1], bar->GetWidth(), bar->GetHeight()) +
                       " labels " + bar->GetLabelFormat() +
                       keptNumbers(bar->GetNumberOfLabels(), bar->GetTextPad(), bar->GetTextPosition(),
                                   bar->GetUnconstrainedFontSize(), bar->GetDrawBackground(),
                                   bar->GetBackgroundProperty()->GetOpacity()) +
                       three(bar->GetBackgroundProperty()->GetColor()) + textOf(bar->GetLabelTextProperty()) +
                       " range" + keptNumbers(table->GetRange()[0], table->GetRange()[1]) + " colours";
    for (int i = 0; i <= 8; ++i) {
      double rgb[3];
      table->GetColor(table->GetRange()[0] + (table->GetRange()[1] - table->GetRange()[0]) * i / 8.0, rgb);
      line += three(rgb);
    }
    return line;
  }
  if (auto* names = vtkLegendBoxActor::SafeDownCast(prop)) {
    std::string line = "names at" +
                       keptNumbers(names->GetPosition()[0], names->GetPosition()[1], names->GetPosition2()[0],
                                   names->GetPosition2()[1], names->GetUseBackground(), names->GetBorder(),
                                   names->GetBackgroundOpacity(), names->GetScalarVisibility()) +
                       three(names->GetBackgroundColor()) + textOf(names->GetEntryTextProperty());
    for (int i = 0; i < names->GetNumberOfEntries(); ++i) {
      vtkPolyData* square = names->GetEntrySymbol(i);
      vtkDataArray* color = square->GetCellData()->GetScalars();
      line += std::string(" '") + names->GetEntryString(i) + "'" +
              keptNumbers(square->GetNumberOfCells(), color->GetComponent(0, 0), color->GetComponent(0, 1),
                          color->GetComponent(0, 2), square->GetBounds()[0], square->GetBounds()[1],
                          square->GetBounds()[2], square->GetBounds()[3]);
    }
    return line;
  }
  auto* words = vtkTextActor::SafeDownCast(prop);
  return std::string("caption '") + words->GetInput() + "' at" +
         keptNumbers(words->GetPosition()[0], words->GetPosition()[1],
                     words->GetPositionCoordinate()->GetCoordinateSystem()) +
         textOf(words->GetTextProperty());
}

TEST(ViewLegend, HoldsTheNameAndTheScaleOfEachView) {
  std::vector<std::string> lines;
  vtkNew<vtkRenderer> renderer;
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->AddRenderer(renderer);
  ViewLegend legend;
  std::vector<std::string> many;
  for (int i = 0; i < 27; ++i) many.push_back("p" + std::to_string(i));
  const auto show = [&](const SurfaceViewRow& row, double low, double high, const std::vector<std::string>& names) {
    legend.show(renderer, row, low, high, names);
    lines.push_back("-- " + std::string(row.id) + keptNumbers(window->GetSize()[0], low, high));
    vtkCollectionSimpleIterator it;
    vtkPropCollection* props = renderer->GetViewProps();
    props->InitTraversal(it);
    while (vtkProp* prop = props->GetNextProp(it)) lines.push_back(lineOf(prop));
  };
  for (const int width : {1000, 799, 800}) {
    window->SetSize(width, 600);
    for (const SurfaceViewRow& row : surfaceViews()) show(row, 0.3, 7.1, {"hall", "a longer name", "c"});
  }
  const SurfaceViewRow& weights = surfaceViews()[static_cast<std::size_t>(*findSurfaceView("weights"))];
  show(weights, 0, 1, {});
  show(weights, 0, 1, many);
  const SurfaceViewRow& level = surfaceViews()[static_cast<std::size_t>(*findSurfaceView("level"))];
  show(level, 2.0, 12.0, {});
  show(level, 2.0, 2.1, {});
  show(level, 2.0, 2.09, {});
  window->RemoveRenderer(renderer);
  test::expectKeptValues("unit/values/view_legend.txt", lines);
}

TEST(ShownView, TakesARangeFromTheSceneWhereTheViewHasNone) {
  SceneContent content;
  for (const auto& [size, faceSize] : {std::pair(glm::dvec3(2.0, 3.0, 6.0), 64), {glm::dvec3(1.0, 4.0, 4.2), 256}}) {
    Probe probe;
    probe.box = {glm::dvec3(-0.4), size - 0.4};
    probe.faceSize = faceSize;
    content.scene.probes.push_back(probe);
  }
  const auto rangeOf = [&](const char* id, std::optional<double> low = {}, std::optional<double> high = {}) {
    ShownView view;
    view.set({*findSurfaceView(id), low, high});
    EXPECT_EQ(view.any(), std::string(id) != "picture");
    return view.range(content);
  };
  using Range = std::pair<double, double>;
  const auto expectRange = [](const Range& found, double low, double high) {
    EXPECT_NEAR(found.first, low, 1e-12);
    EXPECT_NEAR(found.second, high, 1e-9);
  };
  expectRange(rangeOf("picture"), 0.0, 1.0);
  expectRange(rangeOf("hit-distance"), 0.0, 7.0);  // a diagonal of 7
  expectRange(rangeOf("hit-error"), 0.0, 0.7);
  expectRange(rangeOf("lookups"), 0.0, 8.0);
  expectRange(rangeOf("direction-error"), 0.0, 30.0);
  expectRange(rangeOf("hit-distance", 1.5), 1.5, 7.0);
  expectRange(rangeOf("hit-distance", {}, 2.5), 0.0, 2.5);
  expectRange(rangeOf("roughness", 0.2, 0.7), 0.2, 0.7);
  // Of 256 texels, down to the level with the last roughness.
  const double levels = rangeOf("level").second;
  content.scene.probes.pop_back();
  EXPECT_NEAR(levels - rangeOf("level").second, 2.0, 1e-12) << "two halvings more than of 64";
  content.scene.probes[0].box.max.x += 0.31;  // a diagonal of 7.094...: two digits, upwards
  expectRange(rangeOf("true-distance"), 0.0, 7.1);
  expectRange(rangeOf("hit-error"), 0.0, 0.71);
  content.scene.probes[0].box = {glm::dvec3(0.0), glm::dvec3(123.0, 0.0, 0.0)};
  expectRange(rangeOf("true-distance"), 0.0, 130.0);
  content.scene.probes.clear();
  const double size = glm::length(content.bounds().size());
  expectRange(rangeOf("true-distance"), 0.0, std::ceil(size * 10.0 - 1e-9) / 10.0);
  expectRange(rangeOf("level"), 0.0, 1.0);
}

TEST(ShownView, KnowsTheTracedLightOfAPixel) {
  ImageRgbaF light;
  light.width = 3;
  light.height = 2;
  for (int i = 0; i < 6 * 4; ++i) light.pixels.push_back(0.25f + 0.5f * static_cast<float>(i));
  light.pixels[4 * 4 + 3] = -1.0f;  // the middle of the lower row
  ShownView view;
  EXPECT_FALSE(view.truthAt(0, 0, 9, 4));
  view.setTruth(light);
  // Nine columns to three, four rows to two.
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 9; ++x) {
      const int texel = (y / 2) * 3 + x / 3;
      const auto found = view.truthAt(x, y, 9, 4);
      ASSERT_EQ(found.has_value(), texel != 4) << x << ", " << y;
      if (!found) continue;
      for (int c = 0; c < 4; ++c) {
        EXPECT_EQ((*found)[c], light.pixels[static_cast<std::size_t>(4 * texel + c)]) << x << ", " << y;
      }
    }
  }
  EXPECT_FALSE(view.truthAt(0, 0, 0, 4));
  EXPECT_FALSE(view.truthAt(0, 0, 9, 0));
  EXPECT_EQ(view.truthAt(40, 90, 9, 4)->x, light.pixels[20]) << "beyond the edge: its last";
}

}  // namespace
}  // namespace boxprobe
