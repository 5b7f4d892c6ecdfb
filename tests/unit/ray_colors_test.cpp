// The colours of rays and their bar, by each quantity: numbers over their range, choices that occur.
#include "filters/vtk/rays/ray_colors.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkScalarBarActor.h>
#include <vtkStringArray.h>
#include <vtkVariant.h>

#include "filters/core/picture/probe_color.h"
#include "filters/vtk/rays/ray_arrays.h"

namespace boxprobe {
namespace {

/// Five rays with each number another one.
vtkSmartPointer<vtkPolyData> someRays() {
  auto rays = vtkSmartPointer<vtkPolyData>::New();
  const auto ints = [&rays](const char* name, const std::vector<int>& values) {
    vtkNew<vtkIntArray> array;
    array->SetName(name);
    for (const int value : values) array->InsertNextValue(value);
    rays->GetCellData()->AddArray(array);
  };
  const auto doubles = [&rays](const char* name, const std::vector<double>& values) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (const double value : values) array->InsertNextValue(value);
    rays->GetCellData()->AddArray(array);
  };
  ints(ray_array::kKind, {2, 0, 9, 2, 6});
  ints(ray_array::kFace, {5, -1, 0, 3, 3});
  ints(ray_array::kProbe, {1, 1, -1, 0, 7});
  doubles(ray_array::kHitDistance, {3.5, -1.0, 0.0, 7.0, 14.0});
  doubles(ray_array::kError, {0.02, -1.0, 0.01, 0.0, 0.04});
  vtkNew<vtkStringArray> names;
  names->SetName(ray_array::kProbeNames);
  names->InsertNextValue("hall");
  names->InsertNextValue("stairs");
  rays->GetFieldData()->AddArray(names);
  return rays;
}

void expectColor(const glm::vec3& found, const glm::vec3& wanted, const std::string& what) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], wanted[c], 4e-3) << what << ", channel " << c;
}

struct Bar {
  explicit Bar(const RayColors& colors) { colors.describe(bar); }
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    vtkScalarsToColors* table = bar->GetLookupTable();
    for (vtkIdType i = 0; i < table->GetNumberOfAnnotatedValues(); ++i) {
      all.push_back(table->GetAnnotatedValue(i).ToString() + " " + table->GetAnnotation(i));
    }
    return all;
  }
  vtkNew<vtkScalarBarActor> bar;
};
using Names = std::vector<std::string>;

TEST(RayColors, OfNumbersGoOverTheirRange) {
  const auto rays = someRays();
  const glm::vec3 blue(0.42f, 0.55f, 1.0f), middle(0.20f, 0.76f, 0.67f), yellow(1.0f, 0.95f, 0.5f), grey(0.72f);
  const RayColors distance(rays, RayColoring::HitDistance, {});
  EXPECT_EQ(distance.range(), (RayRange{0.0, 14.0}));
  expectColor(distance.color(2), blue, "0 of 14");
  expectColor(distance.color(3), middle, "7 of 14");
  expectColor(distance.color(4), yellow, "14 of 14");
  expectColor(distance.color(1), grey, "undefined");
  expectColor(distance.color(5), grey, "beyond the last");
  const Bar bar(distance);
  EXPECT_STREQ(bar.bar->GetTitle(), "Hit distance\nscene units");
  EXPECT_STREQ(bar.bar->GetLabelFormat(), "%.1f");
  EXPECT_EQ(bar.bar->GetWidth(), 0.13);
  EXPECT_EQ(bar.bar->GetHeight(), 0.36);
  EXPECT_NE(bar.bar->GetLookupTable(), nullptr);

  const RayColors error(rays, RayColoring::Error, {});
  EXPECT_EQ(error.range(), (RayRange{0.0, 0.04}));
  expectColor(error.color(0), middle, "0.02 of 0.04");
  EXPECT_STREQ(Bar(error).bar->GetTitle(), "Hit error\nscene units");
  EXPECT_STREQ(Bar(error).bar->GetLabelFormat(), "%.2e");

  const RayColors locked(rays, RayColoring::HitDistance, RayRange{3.5, 10.5});
  EXPECT_EQ(locked.range(), (RayRange{3.5, 10.5}));
  expectColor(locked.color(2), blue, "below the range");
  expectColor(locked.color(0), blue, "its lower end");
  expectColor(locked.color(3), middle, "its middle");
  expectColor(locked.color(4), yellow, "above the range");
  EXPECT_STREQ(Bar(locked).bar->GetLabelFormat(), "%.2f");
  for (const auto& [size, format] : {std::pair(10.0, "%.1f"), {9.99, "%.2f"}, {0.1, "%.2f"}, {0.099, "%.2e"}}) {
    EXPECT_STREQ(Bar(RayColors(rays, RayColoring::HitDistance, RayRange{0.0, size})).bar->GetLabelFormat(), format);
  }
  // A bar of no length is none.
  const RayColors none(rays, RayColoring::HitDistance, RayRange{2.0, 2.0});
  EXPECT_EQ(none.range(), (RayRange{2.0, 2.0 + 1e-6}));
}

TEST(RayColors, OfChoicesAreThoseThatOccur) {
  const auto rays = someRays();
  const RayColors kind(rays, RayColoring::Kind, {});
  expectColor(kind.color(0), {1.00f, 0.65f, 0.10f}, "reflected");
  expectColor(kind.color(1), {0.45f, 0.78f, 1.00f}, "eye");
  expectColor(kind.color(2), {0.66f, 0.62f, 0.95f}, "shadow");
  expectColor(kind.color(4), {1.00f, 0.36f, 0.16f}, "error");
  expectColor(kind.color(5), glm::vec3(0.72f), "beyond the last");
  EXPECT_EQ(kind.range(), (RayRange{0.0, 9.0}));
  const Bar bar(kind);
  EXPECT_STREQ(bar.bar->GetTitle(), "Rays");
  EXPECT_EQ(bar.names(), (Names{"0 eye ray", "2 reflected ray", "6 error", "9 shadow ray"}));
  EXPECT_EQ(bar.bar->GetWidth(), 0.055);
  EXPECT_NEAR(bar.bar->GetHeight(), 0.08 + 4 * 0.045, 1e-12);
  auto* table = vtkLookupTable::SafeDownCast(bar.bar->GetLookupTable());
  ASSERT_NE(table, nullptr);
  EXPECT_TRUE(table->GetIndexedLookup());
  ASSERT_EQ(table->GetNumberOfTableValues(), 4);
  const double* second = table->GetTableValue(1);
  expectColor({second[0], second[1], second[2]}, {1.00f, 0.65f, 0.10f}, "its swatch");
  EXPECT_EQ(second[3], 1.0);

  const RayColors face(rays, RayColoring::Face, {});
  const auto& faces = faceColors();
  expectColor(face.color(0), 0.25f + 0.75f * faces[5], "+z");
  expectColor(face.color(2), 0.25f + 0.75f * faces[0], "-x");
  expectColor(face.color(1), glm::vec3(0.72f), "no face");
  EXPECT_EQ(Bar(face).names(), (Names{"0 -x", "3 +y", "5 +z"}));
  EXPECT_STREQ(Bar(face).bar->GetTitle(), "Face hit");

  const RayColors probe(rays, RayColoring::Probe, {});
  expectColor(probe.color(0), probeColor(1), "the second");
  expectColor(probe.color(3), probeColor(0), "the first");
  expectColor(probe.color(4), glm::vec3(0.72f), "one without a name");
  EXPECT_EQ(Bar(probe).names(), (Names{"0 hall", "1 stairs"}));
  EXPECT_STREQ(Bar(probe).bar->GetTitle(), "Probe");
  EXPECT_EQ(probe.range(), (RayRange{0.0, 1.0}));
  // Of many choices the bar goes no higher.
  vtkNew<vtkIntArray> all;
  all->SetName(ray_array::kKind);
  for (int i = 0; i < 10; ++i) all->InsertNextValue(i);
  rays->GetCellData()->AddArray(all);
  EXPECT_NEAR(Bar(RayColors(rays, RayColoring::Kind, {})).bar->GetHeight(), 0.40, 1e-12);
}

TEST(RayColors, WithoutAnArrayAreGrey) {
  vtkNew<vtkPolyData> empty;
  for (const RayColoring coloring : {RayColoring::Kind, RayColoring::HitDistance, RayColoring::Probe}) {
    const RayColors colors(empty, coloring, {});
    expectColor(colors.color(0), glm::vec3(0.72f), "nothing");
    EXPECT_TRUE(Bar(colors).names().empty());
  }
}

}  // namespace
}  // namespace boxprobe
