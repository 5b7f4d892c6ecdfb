// What the handles' layers hold and what each drag makes of a probe, prop by prop and handle by handle, against
// handle_values.txt and dragged_values.txt: no window is opened.
#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <map>
#include <sstream>

#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"
#include "tests/support/kept_values.h"

namespace boxprobe {
namespace {

using test::keptNumbers;
using Shown = vtkReflectionProbeRepresentation;

constexpr int kWidth = 640, kHeight = 420;

template <typename Vector>
std::string three(const Vector& v) {
  return keptNumbers(v[0], v[1], v[2]);
}

Probe probe(const char* name, const Box& box, const glm::dvec3& origin, const glm::dvec3& degrees) {
  Probe made;
  made.name = name;
  made.box = box;
  made.origin = origin;
  made.rotationDegrees = degrees;
  made.blendDistance = {{0.11, 0.07, 0.16}, {0.21, 0.09, 0.13}};
  return made;
}

/// Turned about all axes with an influence of its own; about Y alone; not at all and without a blend distance; far.
std::vector<Probe> someProbes() {
  std::vector<Probe> all = {probe("a", {{-1.3, -0.8, -1.2}, {1.1, 0.6, 0.9}}, {0.2, -0.3, 0.1}, {4, 17, -3}),
                            probe("b", {{1.6, -0.7, -1.9}, {2.9, 0.9, -0.4}}, {2.1, 0.2, -1.2}, {0, -38, 0}),
                            probe("c", {{-3.1, -0.6, -0.9}, {-1.9, 0.4, 0.7}}, {-2.6, 0.1, -0.2}, {0, 0, 0}),
                            probe("d", {{-2.0, -1.0, -14.0}, {1.5, 1.7, -11.0}}, {-0.4, 0.5, -12.2}, {0, 0, 0})};
  all[0].influence = Box{{-1.5, -0.9, -1.6}, {1.4, 0.9, 1.3}};
  all[2].blendDistance = {glm::dvec3(0.0), glm::dvec3(0.0)};
  return all;
}

/// Extent of what an actor draws, and a sum that depends on the order of its points, in the world.
std::string shapeOf(vtkActor* actor) {
  vtkPolyData* data = vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput();
  double low[3] = {1e9, 1e9, 1e9}, high[3] = {-1e9, -1e9, -1e9}, sum[3] = {0, 0, 0};
  const vtkIdType count = data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i) {
    double p[4] = {0, 0, 0, 1}, world[4];
    data->GetPoint(i, p);
    actor->GetMatrix()->MultiplyPoint(p, world);
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], world[axis]);
      high[axis] = std::max(high[axis], world[axis]);
      sum[axis] += world[axis] * static_cast<double>(i + 1) / static_cast<double>(count * count);
    }
  }
  return std::to_string(count) + " points," + keptNumbers(data->GetNumberOfCells()) + " cells from" + three(low) +
         " to" + three(high) + " sum" + three(sum);
}

class Stage {
 public:
  Stage() {
    window->SetOffScreenRendering(1);
    window->SetSize(800, 500);
    scene->SetViewport(0.1, 0.06, 0.9, 0.9);  // kWidth x kHeight
    window->AddRenderer(scene);
    vtkCamera* camera = scene->GetActiveCamera();
    camera->SetPosition(2.9, 2.3, 6.6);
    camera->SetFocalPoint(0.1, -0.1, 0.2);
    camera->SetViewAngle(41);
    shown->SetRenderer(scene);
  }
  ~Stage() {
    shown->SetRenderer(nullptr);
    window->RemoveRenderer(scene);
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  ViewProjection view() const { return {scene->GetActiveCamera(), kWidth, kHeight}; }

  void addWall(const glm::dvec3& origin, const glm::dvec3& a, const glm::dvec3& b) {
    vtkNew<vtkPlaneSource> source;
    source->SetOrigin(origin.x, origin.y, origin.z);
    source->SetPoint1(a.x, a.y, a.z);
    source->SetPoint2(b.x, b.y, b.z);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    scene->AddActor(actor);
  }

  /// Everything in the layers above the scene, as the next picture would show it.
  void writeLayers(const std::string& title, std::vector<std::string>& lines, bool wordsAlone = false) {
    shown->BuildRepresentation();
    if (!wordsAlone) lines.push_back("-- " + title + ":" + keptNumbers(window->GetNumberOfLayers()) + " layers");
    vtkCollectionSimpleIterator it;
    vtkRendererCollection* all = window->GetRenderers();
    all->InitTraversal(it);
    while (vtkRenderer* layer = all->GetNextRenderer(it)) {
      if (layer == scene) continue;
      const double* v = layer->GetViewport();
      if (!wordsAlone)
        lines.push_back("layer" + keptNumbers(layer->GetLayer(), layer->GetDraw(), layer->GetInteractive(),
                                              layer->GetPreserveDepthBuffer(), v[0], v[1], v[2], v[3]));
      vtkCollectionSimpleIterator each;
      vtkPropCollection* props = layer->GetViewProps();
      props->InitTraversal(each);
      for (int number = 0; vtkProp* prop = props->GetNextProp(each); ++number) {
        if (wordsAlone && vtkTextActor::SafeDownCast(prop) == nullptr) continue;
        if (prop->GetVisibility() != 0) lines.push_back(std::to_string(number) + " " + textOf(prop));
      }
    }
  }

  vtkSmartPointer<vtkRenderWindow> window = vtkSmartPointer<vtkRenderWindow>::New();
  vtkNew<vtkRenderer> scene;
  vtkNew<Shown> shown;

 private:
  static std::string textOf(vtkProp* prop) {
    if (auto* words = vtkTextActor::SafeDownCast(prop)) {
      vtkTextProperty* look = words->GetTextProperty();
      std::string input = words->GetInput();
      std::replace(input.begin(), input.end(), '\n', '|');
      return "'" + input + "' at" + keptNumbers(words->GetPosition()[0], words->GetPosition()[1]) + " justified" +
             keptNumbers(look->GetJustification(), look->GetVerticalJustification(), look->GetFontSize()) + " colour" +
             three(look->GetColor()) + " on" + three(look->GetBackgroundColor()) +
             keptNumbers(look->GetBackgroundOpacity(), prop->GetPickable());
    }
    auto* actor = vtkActor::SafeDownCast(prop);
    vtkProperty* look = actor->GetProperty();
    return "colour" + three(look->GetColor()) + " look" +
           keptNumbers(look->GetOpacity(), look->GetLineWidth(), look->GetLighting(), look->GetFrontfaceCulling(),
                       look->GetAmbient(), look->GetDiffuse(), actor->GetPickable()) +
           " " + shapeOf(actor);
  }
};

std::string valuesOf(const Probe& p) {
  std::string text = "box" + three(p.box.min) + three(p.box.max) + " origin" + three(p.origin) + " turned" +
                     three(p.rotationDegrees) + " blend" + three(p.blendDistance.min) + three(p.blendDistance.max);
  if (p.influence) text += " influence" + three(p.influence->min) + three(p.influence->max);
  return text;
}

std::string nameOf(const Handle& handle) {
  static const char* const kNames[] = {"face", "origin", "influence", "blend", "originAxis", "move", "turn"};
  return std::string(kNames[static_cast<int>(handle.kind)]) +
         keptNumbers(handle.probe, handle.face.axis, handle.face.positive);
}

/// A pixel of each handle that can be found, in the order of rows.
std::vector<std::pair<Handle, glm::dvec2>> handlesOf(const Stage& stage) {
  std::vector<std::pair<Handle, glm::dvec2>> found;
  std::map<std::string, int> pixels;
  const ViewProjection view = stage.view();
  for (int y = 1; y < kHeight; y += 3) {
    for (int x = 1; x < kWidth; x += 3) {
      const auto handle = stage.shown->HandleAt(view, glm::dvec2(x, y));
      // Not at its rim: there another machine might find another one.
      if (handle && ++pixels[nameOf(*handle)] == 7) found.emplace_back(*handle, glm::dvec2(x, y));
    }
  }
  return found;
}

TEST(WidgetValues, OfLayersAndDrags) {
  std::vector<std::string> lines;
  const std::vector<Probe> probes = someProbes();
  {
    Stage stage;
    Shown* shown = stage.shown;
    stage.writeLayers("nothing to show", lines);
    shown->ShowProbes(probes, 0, {0, 2});
    stage.writeLayers("box", lines);
    shown->SetModeToInfluence();
    shown->SetHandleSize(21);
    stage.writeLayers("influence, larger", lines);
    shown->ShowProbes(probes, 1, {1});
    stage.writeLayers("influence of a probe without", lines);
    shown->SetHandleSize(14);
    shown->SetModeToOrigin();
    shown->LeaveOut({false, false, true, false}, {true, false, false, false});
    stage.writeLayers("origin, one hidden", lines);
    shown->LeaveOut({true, false, false, false}, {});
    shown->ShowProbes(probes, 1, {0, 1, 3});
    shown->SetModeToPlace();
    const double colors[8][3] = {{.11, .22, .33}, {.12, .45, .78}, {.91, .32, .54}, {.65, .43, .21},
                                 {.98, .76, .14}, {.35, .57, .79}, {.24, .68, .13}, {.31, .02, .17}};
    shown->SetXAxisColor(colors[0][0], colors[0][1], colors[0][2]);
    shown->SetYAxisColor(colors[1][0], colors[1][1], colors[1][2]);
    shown->SetZAxisColor(colors[2][0], colors[2][1], colors[2][2]);
    shown->SetBoxColor(colors[3][0], colors[3][1], colors[3][2]);
    shown->SetInfluenceColor(colors[4][0], colors[4][1], colors[4][2]);
    shown->SetBlendColor(colors[5][0], colors[5][1], colors[5][2]);
    shown->SetOriginColor(colors[6][0], colors[6][1], colors[6][2]);
    shown->SetHaloColor(colors[7][0], colors[7][1], colors[7][2]);
    stage.window->SetDPI(108);
    stage.writeLayers("place, other colours, finer", lines);
    stage.window->SetDPI(72);
    shown->LeaveOut({}, {});
    shown->ShowProbes(probes, std::nullopt, {});
    stage.scene->GetActiveCamera()->ParallelProjectionOn();
    stage.scene->GetActiveCamera()->SetParallelScale(3.3);
    stage.scene->SetViewport(0.0, 0.06, 0.8, 0.9);
    shown->ShowGhosts({probe("ghost", {{-0.5, -0.4, -0.3}, {0.6, 0.7, 0.8}}, {0, 0, 0}, {0, 31, 0})});
    shown->ShowDrop(std::array<glm::dvec3, 2>{glm::dvec3(0.7, 0.9, -0.4), glm::dvec3(0.7, -0.6, -0.4)});
    stage.writeLayers("none selected, parallel, with a proposal and a drop", lines);
    shown->ShowGhosts({});
    shown->ShowDrop(std::nullopt);
    shown->VisibilityOff();
    stage.writeLayers("not visible", lines);
  }
  for (int mode = Shown::BOX; mode <= Shown::PLACE; ++mode) {
    Stage stage;
    Shown* shown = stage.shown;
    stage.addWall({-1.9, -1, 2}, {-1.9, -1, -2}, {-1.9, 1, 2});
    stage.addWall({-2, 1.1, -2}, {2, 1.1, -2}, {-2, 1.1, 2});
    stage.addWall({-2, -1, -1.7}, {2, -1, -1.7}, {-2, 1, -1.7});
    shown->SetMode(mode);
    shown->SetLengthUnit("ft");
    shown->ShowProbes(probes, 0, {0});
    lines.push_back("-- drags of mode" + keptNumbers(mode));
    for (const auto& [handle, pixel] : handlesOf(stage)) {
      for (int way = 0; way < 5; ++way) {
        if (mode == Shown::ORIGIN && way == 1) continue;
        shown->SetSymmetric(way == 1);
        shown->SetFine(way == 2);
        shown->SetSnapping(way == 3 || way == 4);
        shown->SetSnapToSurfaces(way == 3);
        shown->SetLargestGridStep(0.07);
        shown->SetAngleStep(4);
        shown->SetConstrainedAxis(way == 4 ? 2 : -1);
        shown->Hover(stage.view(), pixel);
        const bool grabbed = shown->Grab(stage.view(), pixel);
        std::string line = nameOf(handle) + " way" +
                           keptNumbers(way, grabbed, shown->GetInteractionState(), shown->GetInteractionFace(),
                                       shown->GetInteractionAxis());
        EXPECT_FALSE(shown->Pull(stage.view(), pixel + glm::dvec2(1, -1)));
        if (const auto now = shown->Pull(stage.view(), pixel + glm::dvec2(31, -23))) {
          std::string readout = shown->GetReadout();
          std::replace(readout.begin(), readout.end(), '\n', '|');
          line += " " + valuesOf(*now) + " '" + readout + "'";
        }
        lines.push_back(line);
        if (way == 0) stage.writeLayers("while dragged", lines, handle.face.axis != 1);
        shown->LetGo();
        if (!grabbed) break;
      }
    }
  }
  test::expectKeptValues("unit/values/handle_values.txt", lines);
}

// Through the events' positions, on a vtkReflectionProbe, and back.
TEST(WidgetValues, OfAProbeThatIsDraggedAndPutBack) {
  std::vector<std::string> lines;
  for (int mode = Shown::BOX; mode <= Shown::PLACE; ++mode) {
    for (const bool atCenter : {false, true}) {
      Stage stage;
      vtkNew<vtkReflectionProbe> dragged;
      dragged->FromProbe(someProbes()[atCenter ? 1 : 0]);
      if (atCenter) dragged->SetOriginAtCenter(true);
      const auto values = [&dragged] {
        std::ostringstream text;
        dragged->PrintSelf(text, vtkIndent());
        std::string all = text.str();
        all = all.substr(all.find("Bounds:"));
        all = all.substr(0, all.find("Importance"));
        std::replace(all.begin(), all.end(), '\n', ' ');
        return all;
      };
      const std::string before = values();
      stage.shown->SetProbe(dragged);
      stage.shown->SetMode(mode);
      const double* b = stage.shown->GetBounds();
      lines.push_back("mode" + keptNumbers(mode, atCenter, b[0], b[1], b[2], b[3], b[4], b[5]) + " " + before);
      for (const auto& [handle, pixel] : handlesOf(stage)) {
        // In the window, from the lower left corner.
        double at[2] = {80.0 + pixel.x, 30.0 + kHeight - pixel.y};
        stage.shown->StartWidgetInteraction(at);
        at[0] += 22;
        at[1] += 27;
        stage.shown->WidgetInteraction(at);
        lines.push_back(nameOf(handle) + keptNumbers(stage.shown->GetDragging(), stage.shown->GetInteractionState()) +
                        " " + values());
        stage.shown->CancelInteraction();
        EXPECT_EQ(values(), before) << nameOf(handle);
        EXPECT_FALSE(stage.shown->GetDragging());
      }
    }
  }
  test::expectKeptValues("unit/values/dragged_values.txt", lines);
}

}  // namespace
}  // namespace boxprobe
