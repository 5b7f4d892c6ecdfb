#include "tests/gui/soak_record.h"

#include <malloc.h>
#include <vtkAxis.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPlot.h>
#include <vtkRenderer.h>
#include <vtkTable.h>

#include <QApplication>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "filters/io/files/atomic_file.h"
#include "filters/io/image/image_file.h"
#include "filters/vtk/gl/window_pixels.h"

namespace boxprobe {

namespace {

constexpr double kMegabyte = 1024.0 * 1024.0;
constexpr int kWidth = 1200, kHeight = 800;

int entriesOf(const char* folder) {
  int count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++count;
  return count;
}

struct Curve {
  const char* name;
  std::function<double(const SoakRow&)> value;
  unsigned char color[3];
};

void addChart(vtkContextScene* scene, const vtkRectf& place, const char* axis, const std::vector<SoakRow>& rows,
              const std::vector<Curve>& curves) {
  vtkNew<vtkTable> table;
  const auto addColumn = [&](const char* name, const std::function<double(const SoakRow&)>& value) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (const SoakRow& row : rows) column->InsertNextValue(value(row));
    table->AddColumn(column);
  };
  addColumn("minutes", [](const SoakRow& row) { return row.minutes; });
  for (const Curve& curve : curves) addColumn(curve.name, curve.value);
  vtkNew<vtkChartXY> chart;
  chart->SetAutoSize(false);
  chart->SetSize(place);
  chart->SetShowLegend(true);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::LEFT);
  chart->GetAxis(vtkAxis::BOTTOM)->SetTitle("minutes");
  chart->GetAxis(vtkAxis::LEFT)->SetTitle(axis);
  double most = 1.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    vtkPlot* line = chart->AddPlot(vtkChart::LINE);
    line->SetInputData(table, 0, static_cast<vtkIdType>(i) + 1);
    line->SetColor(curves[i].color[0], curves[i].color[1], curves[i].color[2], 255);
    line->SetWidth(2.0f);
    for (const SoakRow& row : rows) most = std::max(most, curves[i].value(row));
  }
  // From zero: what grows a little is not to look like much.
  chart->GetAxis(vtkAxis::LEFT)->SetBehavior(vtkAxis::FIXED);
  chart->GetAxis(vtkAxis::LEFT)->SetRange(0.0, 1.25 * most);
  scene->AddItem(chart);
}

}  // namespace

SoakRow lookAtProcess() {
  SoakRow row;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    std::istringstream words(line);
    std::string key;
    double value = 0.0;
    words >> key >> value;
    if (key == "RssAnon:" || key == "RssShmem:") row.residentMegabytes += value / 1024.0;
    if (key == "Threads:") row.threads = static_cast<int>(value);
  }
  const struct mallinfo2 heap = ::mallinfo2();
  row.heapMegabytes = static_cast<double>(heap.uordblks + heap.hblkhd) / kMegabyte;
  row.descriptors = entriesOf("/proc/self/fd") - 1;  // the listing's own
  row.widgets = static_cast<int>(QApplication::allWidgets().size());
  return row;
}

void writeSoakTable(const std::string& path, const std::vector<SoakRow>& rows) {
  std::ostringstream text;
  text << "minutes,scene,resident MB,heap MB,maps MB,descriptors,threads,widgets,programs\n";
  for (const SoakRow& row : rows) {
    text << row.minutes << ',' << row.scene << ',' << row.residentMegabytes << ',' << row.heapMegabytes << ','
         << row.mapMegabytes << ',' << row.descriptors << ',' << row.threads << ',' << row.widgets << ','
         << row.programs << '\n';
  }
  writeTextAtomically(path, text.str());
}

void drawSoak(const std::string& path, const std::vector<SoakRow>& rows) {
  const auto window =
      vtkSmartPointer<vtkOpenGLRenderWindow>::Take(vtkOpenGLRenderWindow::SafeDownCast(vtkRenderWindow::New()));
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(kWidth, kHeight);
  vtkNew<vtkContextView> view;
  view->SetRenderWindow(window);
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  addChart(view->GetScene(), {0.0f, kHeight / 2.0f, kWidth, kHeight / 2.0f}, "MB", rows,
           {{"resident", [](const SoakRow& row) { return row.residentMegabytes; }, {30, 110, 190}},
            {"heap", [](const SoakRow& row) { return row.heapMegabytes; }, {210, 120, 30}},
            {"maps", [](const SoakRow& row) { return row.mapMegabytes; }, {60, 150, 90}}});
  addChart(view->GetScene(), {0.0f, 0.0f, kWidth, kHeight / 2.0f}, "count", rows,
           {{"descriptors", [](const SoakRow& row) { return 1.0 * row.descriptors; }, {30, 110, 190}},
            {"threads", [](const SoakRow& row) { return 1.0 * row.threads; }, {210, 120, 30}},
            {"widgets / 10", [](const SoakRow& row) { return 0.1 * row.widgets; }, {60, 150, 90}},
            {"programs compiled", [](const SoakRow& row) { return 1.0 * row.programs; }, {150, 60, 150}}});
  // Where the axes lie is known after a first frame.
  window->Render();
  window->Render();
  savePng(path, windowPixels(window));
}

}  // namespace boxprobe
