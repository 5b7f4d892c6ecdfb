// vtkReflectionProbe and vtkReflectionProbes as a VTK program uses them: what the next Render() captures by itself and
// what it does not, in steps and at once, what is said, and that nothing is left of them.
#include <vtkAssembly.h>
#include <vtkCallbackCommand.h>
#include <vtkDataSetMapper.h>
#include <vtkHardwareSelector.h>
#include <vtkInformation.h>
#include <vtkLODActor.h>
#include <vtkLightCollection.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderer.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkSphereSource.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "filters/core/base/version.h"
#include "filters/core/scene/scene.h"
#include "filters/io/image/image_file.h"
#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/actors/vtkReflectionProbes.h"
#include "tests/image/vtk_room.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

/// Counts events, and keeps the lines of errors and warnings.
struct Listener {
  explicit Listener(vtkObject* object) {
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long event, void* client, void* data) {
      auto* self = static_cast<Listener*>(client);
      if (event == vtkCommand::StartEvent) ++self->starts;
      if (event == vtkCommand::EndEvent) ++self->ends;
      if (event == vtkCommand::ProgressEvent) self->progress.push_back(*static_cast<double*>(data));
      if (event == vtkCommand::ErrorEvent) self->errors.emplace_back(static_cast<const char*>(data));
      if (event == vtkCommand::WarningEvent) self->warnings.emplace_back(static_cast<const char*>(data));
    });
    object->AddObserver(vtkCommand::AnyEvent, command);
  }
  vtkNew<vtkCallbackCommand> command;
  int starts = 0, ends = 0;
  std::vector<double> progress;
  std::vector<std::string> errors, warnings;
};

struct LitRoom : Room {
  LitRoom() {
    probe->SetBounds(-2, 2, -1, 1, -2, 2);
    probe->SetFaceSize(64);
    probes->SetRenderer(renderer);
    probes->AddProbe(probe);
    probes->SetSeenByProbes(floor, false);
  }
  std::array<int, 3> mirrored() const { return at(picture(), kMirroredX, kMirroredY); }

  vtkNew<vtkReflectionProbe> probe;
  vtkNew<vtkReflectionProbes> probes;
  Listener listener{probes};
};

TEST(ReflectionProbes, TheFirstRenderCaptures) {
  const LitRoom room;
  expectNear(room.mirrored(), {128, 128, 128}, 2);
  EXPECT_EQ(room.listener.starts, 1);
  EXPECT_EQ(room.listener.ends, 1);
  ASSERT_FALSE(room.listener.progress.empty());
  EXPECT_DOUBLE_EQ(room.listener.progress.back(), 1.0);
  for (std::size_t i = 1; i < room.listener.progress.size(); ++i) {
    EXPECT_GE(room.listener.progress[i], room.listener.progress[i - 1]);
  }
  EXPECT_TRUE(room.listener.errors.empty()) << room.listener.errors.front();
  EXPECT_TRUE(room.listener.warnings.empty()) << room.listener.warnings.front();
  EXPECT_FALSE(room.probes->GetStale());
}

TEST(ReflectionProbes, ARendererMayComeToItsWindowLater) {
  LitRoom room;
  auto other = makeWindow(160, 160);
  room.window->RemoveRenderer(room.renderer);
  other->AddRenderer(room.renderer);
  other->Render();
  expectNear(at(windowPixels(other), kMirroredX, kMirroredY), {128, 128, 128}, 2);
  other->RemoveRenderer(room.renderer);
}

TEST(ReflectionProbes, AWindowMayHaveSeveralSamplesAndPeelLayers) {
  LitRoom room;
  auto window =
      vtkSmartPointer<vtkOpenGLRenderWindow>::Take(vtkOpenGLRenderWindow::SafeDownCast(vtkRenderWindow::New()));
  window->SetOffScreenRendering(true);
  window->SetSize(160, 160);
  window->SetMultiSamples(4);
  window->SetAlphaBitPlanes(true);
  room.window->RemoveRenderer(room.renderer);
  window->AddRenderer(room.renderer);
  room.renderer->UseDepthPeelingOn();
  const auto veil = plane({-1, -0.5, 1}, {-0.5, -0.5, 1}, {-1, 0.5, 1});
  veil->GetProperty()->SetInterpolationToPBR();
  veil->GetProperty()->SetOpacity(0.3);
  room.renderer->AddActor(veil);
  for (int frame = 0; frame < 2; ++frame) {
    window->Render();
    expectNear(at(windowPixels(window), kMirroredX, kMirroredY), {128, 128, 128}, 2);
  }
  EXPECT_TRUE(room.listener.errors.empty()) << room.listener.errors.front();
  room.probes->SetRenderer(nullptr);
  window->RemoveRenderer(room.renderer);
}

TEST(ReflectionProbes, PickingFindsTheActorsAndLeavesThePicture) {
  const LitRoom room;
  const ImageRgba8 before = room.picture();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(room.renderer);
  selector->SetArea(kMirroredX, 159 - kMirroredY, kMirroredX, 159 - kMirroredY);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  ASSERT_EQ(selection->GetNumberOfNodes(), 1u);
  vtkInformation* found = selection->GetNode(0)->GetProperties();
  EXPECT_EQ(found->Get(vtkSelectionNode::PROP()), room.floor.Get());
  EXPECT_EQ(room.picture().pixels, before.pixels);
  EXPECT_EQ(room.listener.starts, 1);
  EXPECT_TRUE(room.listener.errors.empty()) << room.listener.errors.front();
}

// As a Qt widget does that gets another parent.
TEST(ReflectionProbes, AWindowMayGetAnotherContext) {
  const LitRoom room;
  expectNear(room.mirrored(), {128, 128, 128}, 2);
  room.window->Finalize();
  EXPECT_TRUE(room.probes->GetStale());
  for (int frame = 0; frame < 2; ++frame) expectNear(room.mirrored(), {128, 128, 128}, 2);
  EXPECT_EQ(room.listener.starts, 2);
  room.probes->ReleaseGraphicsResources();
  expectNear(room.mirrored(), {128, 128, 128}, 2);
  EXPECT_EQ(room.listener.starts, 3);
  EXPECT_TRUE(room.listener.errors.empty()) << room.listener.errors.front();
}

TEST(ReflectionProbes, AtRestNothingIsCapturedAgain) {
  const LitRoom room;
  room.picture();
  for (int frame = 0; frame < 3; ++frame) {
    room.look(room.renderer, 0.1 * frame);
    room.picture();
  }
  EXPECT_EQ(room.listener.starts, 1);
}

TEST(ReflectionProbes, ALightThatFollowsTheCameraMakesNothingStale) {
  LitRoom room;
  room.renderer->RemoveAllLights();  // VTK makes its own then, at the camera
  for (int frame = 0; frame < 4; ++frame) {
    room.look(room.renderer, 0.3 * frame);
    room.picture();
  }
  EXPECT_EQ(room.renderer->GetLights()->GetNumberOfItems(), 1);
  EXPECT_EQ(room.listener.starts, 1);
}

TEST(ReflectionProbes, WhatChangesIsCapturedAgain) {
  const LitRoom room;
  room.picture();
  int captures = 1;
  const auto changed = [&](const char* what) {
    EXPECT_TRUE(room.probes->GetStale()) << what;
    room.picture();
    EXPECT_EQ(room.listener.starts, ++captures) << what;
    EXPECT_FALSE(room.probes->GetStale()) << what;
  };
  vtkActor* wall = room.others[2];
  wall->GetProperty()->SetColor(0.25, 0.5, 0.75);
  changed("colour");
  expectNear(room.mirrored(), {64, 128, 191}, 2);
  wall->SetPosition(0.0, 0.0, -0.1);
  changed("moved");
  wall->VisibilityOff();
  changed("hidden");
  expectNear(room.mirrored(), {0, 0, 0}, 1);
  wall->VisibilityOn();
  changed("shown");
  room.renderer->RemoveActor(wall);
  changed("removed");
  expectNear(room.mirrored(), {0, 0, 0}, 1);
  room.renderer->AddActor(wall);
  changed("added");
  vtkNew<vtkPlaneSource> other;
  other->SetOrigin(-2, -1, -1.9);
  other->SetPoint1(2, -1, -1.9);
  other->SetPoint2(-2, 1, -1.9);
  wall->GetMapper()->SetInputConnection(other->GetOutputPort());
  changed("another geometry");
  other->SetPoint2(-2, 0.9, -1.9);
  changed("a source's parameter");
  vtkNew<vtkLight> lamp;
  lamp->SetPosition(0, 0.5, 0);
  lamp->SetPositional(true);
  room.renderer->AddLight(lamp);
  changed("a light");
  lamp->SetIntensity(0.5);
  changed("its intensity");
  room.renderer->RemoveLight(lamp);
  changed("no light");
  room.renderer->SetBackground(0.1, 0.2, 0.3);
  changed("background");
  room.probe->SetOrigin(0.1, 0, 0);
  changed("origin");
  room.probe->SetFaceSize(32);
  changed("face size");
  EXPECT_TRUE(room.listener.errors.empty()) << room.listener.errors.front();
}

TEST(ReflectionProbes, WhatNeedsNoCaptureHasNone) {
  const LitRoom room;
  const ImageRgba8 before = room.picture();
  room.probe->SetOrigin(0, 0, 0);  // where it is
  room.probe->SetTechnique("infinite");
  EXPECT_GT(meanDifference(before, room.picture()), 1.0);
  room.probe->SetTechnique("box");
  room.probe->SetBounds(-2, 2, -1, 1, -2, 2.5);
  room.picture();
  room.others[0]->GetProperty()->SetColor(1, 0, 0);  // as it was
  room.picture();
  EXPECT_EQ(room.listener.starts, 1);
}

TEST(ReflectionProbes, WithoutAutoUpdateStaleMapsStayAndAreKnown) {
  const LitRoom room;
  room.picture();
  room.probes->AutoUpdateOff();
  room.others[2]->GetProperty()->SetColor(1, 1, 0);
  expectNear(room.mirrored(), {128, 128, 128}, 2);
  EXPECT_TRUE(room.probes->GetStale());
  EXPECT_TRUE(room.probes->Update());
  EXPECT_FALSE(room.probes->GetStale());
  expectNear(room.mirrored(), {255, 255, 0}, 2);
}

TEST(ReflectionProbes, InStepsThePictureStaysUntilTheMapsAreWhole) {
  const LitRoom room;
  room.picture();
  room.probes->SetStepsPerRender(1);
  room.others[2]->GetProperty()->SetColor(1, 1, 0);
  int renders = 0;
  while (room.probes->GetStale() && renders < 100) {
    const auto seen = room.mirrored();
    ++renders;
    if (room.listener.ends == 1) expectNear(seen, {128, 128, 128}, 2);
  }
  std::printf("%d renders of one step each\n", renders);
  EXPECT_GT(renders, 6);
  expectNear(room.mirrored(), {255, 255, 0}, 2);
  // By hand, the same.
  room.probes->AutoUpdateOff();
  room.others[2]->GetProperty()->SetColor(0, 1, 1);
  int steps = 1;
  while (room.probes->UpdateStep()) ++steps;
  EXPECT_GT(steps, 6);
  expectNear(room.mirrored(), {0, 255, 255}, 2);
}

TEST(ReflectionProbes, FacesThatShowNothingOfAChangeAreKept) {
  const LitRoom room;
  room.probes->AutoUpdateOff();
  room.window->Render();  // now there is a context
  const auto steps = [&room] {
    int count = 1;
    while (room.probes->UpdateStep()) ++count;
    return count;
  };
  const int first = steps();
  room.others[2]->GetProperty()->SetColor(0.25, 0.5, 0.75);  // behind the origin: neither floor, ceiling nor front
  const int again = steps();
  std::printf("%d steps, and %d after one wall was painted\n", first, again);
  EXPECT_EQ(first - again, 3);
  const LitRoom fresh;
  fresh.others[2]->GetProperty()->SetColor(0.25, 0.5, 0.75);
  EXPECT_EQ(room.picture().pixels, fresh.picture().pixels);
  room.probes->Capture();  // all of it, asked for
  EXPECT_EQ(room.picture().pixels, fresh.picture().pixels);
}

TEST(ReflectionProbes, NothingIsLeftOfThem) {
  Room room;
  const ImageRgba8 stock = room.picture();
  {
    vtkNew<vtkReflectionProbe> probe;
    probe->SetBounds(-2, 2, -1, 1, -2, 2);
    vtkNew<vtkReflectionProbes> probes;
    probes->SetRenderer(room.renderer);
    probes->AddProbe(probe);
    EXPECT_NE(room.picture().pixels, stock.pixels);
    probes->SetRenderer(nullptr);
    EXPECT_EQ(room.picture().pixels, stock.pixels);
    probes->SetRenderer(room.renderer);
    EXPECT_NE(room.picture().pixels, stock.pixels);
  }
  EXPECT_EQ(room.picture().pixels, stock.pixels);
  EXPECT_EQ(room.floor->GetPropertyKeys(), nullptr);
}

TEST(ReflectionProbes, TheSecondObjectOnARendererWaits) {
  LitRoom room;
  room.picture();
  vtkNew<vtkReflectionProbe> probe;
  probe->SetBounds(-2, 2, -1, 1, -2, 2);
  probe->SetFaceSize(32);
  vtkNew<vtkReflectionProbes> second;
  const Listener listener(second);
  second->SetRenderer(room.renderer);
  second->AddProbe(probe);
  second->SetSeenByProbes(room.floor, false);
  for (int frame = 0; frame < 3; ++frame) expectNear(room.mirrored(), {128, 128, 128}, 2);
  ASSERT_EQ(listener.errors.size(), 1u);
  EXPECT_NE(listener.errors[0].find("another object"), std::string::npos) << listener.errors[0];
  room.probes->SetRenderer(nullptr);
  second->ClearError();
  for (int frame = 0; frame < 2; ++frame) expectNear(room.mirrored(), {128, 128, 128}, 2);
  EXPECT_STREQ(second->GetLastError(), "");
}

TEST(ReflectionProbes, ComeAndGo) {
  const LitRoom room;
  room.picture();
  vtkNew<vtkReflectionProbe> second;
  second->SetName("probe");
  second->SetBounds(-2, 2, -1, 1, -2, 2);
  second->SetFaceSize(32);
  second->SetImportance(2.0);
  room.probes->AddProbe(second);
  EXPECT_EQ(room.probes->GetNumberOfProbes(), 2);
  EXPECT_EQ(room.probes->GetProbe(1), second.GetPointer());
  EXPECT_EQ(room.probes->GetProbe(2), nullptr);
  room.picture();
  second->SetIntensity(0.0);
  expectNear(room.mirrored(), {0, 0, 0}, 1);
  second->SetEnabled(false);
  expectNear(room.mirrored(), {128, 128, 128}, 2);
  second->SetEnabled(true);
  expectNear(room.mirrored(), {0, 0, 0}, 1);
  room.probes->RemoveProbe(second);
  EXPECT_EQ(room.probes->GetNumberOfProbes(), 1);
  expectNear(room.mirrored(), {128, 128, 128}, 2);
  room.probes->RemoveAllProbes();
  expectNear(room.mirrored(), {0, 0, 0}, 0);
  EXPECT_TRUE(room.listener.errors.empty()) << room.listener.errors.front();
}

TEST(ReflectionProbes, RefusedValuesAreSaidOnceAndChangeNothing) {
  const LitRoom room;
  room.picture();
  room.probe->SetFaceSize(100);
  expectNear(room.mirrored(), {128, 128, 128}, 2);
  room.picture();
  ASSERT_EQ(room.listener.errors.size(), 1u);
  EXPECT_NE(room.listener.errors[0].find("probes.probe.faceSize"), std::string::npos) << room.listener.errors[0];
  EXPECT_NE(std::string(room.probes->GetLastError()).find("faceSize"), std::string::npos);
  room.probe->SetFaceSize(64);
  room.picture();
  room.probe->SetTechnique("bix");
  room.picture();
  EXPECT_EQ(room.listener.errors.size(), 2u);
  room.probes->ClearError();
  EXPECT_STREQ(room.probes->GetLastError(), "");
}

TEST(ReflectionProbes, NullIsSaidAndNothingMore) {
  vtkNew<vtkReflectionProbes> probes;
  const Listener listener(probes);
  probes->AddProbe(nullptr);
  probes->RemoveProbe(nullptr);
  probes->SetSeenByProbes(nullptr, true);
  probes->SetUsed(nullptr, true);
  probes->SetRenderer(nullptr);
  EXPECT_FALSE(probes->Update());
  EXPECT_FALSE(probes->UpdateStep());
  EXPECT_FALSE(probes->Capture());
  EXPECT_FALSE(probes->LoadMaps(nullptr, nullptr));
  EXPECT_FALSE(probes->GetStale());
  probes->ReleaseGraphicsResources();
  EXPECT_EQ(listener.errors.size(), 7u);
  vtkNew<vtkReflectionProbe> probe;
  probe->SetTechnique(nullptr);
  probes->AddProbe(probe);
  vtkNew<vtkRenderer> nowhere;
  probes->SetRenderer(nowhere);
  EXPECT_FALSE(probes->Update());
  EXPECT_NE(std::string(probes->GetLastError()), "");
}

TEST(ReflectionProbes, AProbeThatLightsNothingWarns) {
  const LitRoom room;
  room.probe->SetBlendDistance(1.0);
  room.picture();
  room.picture();
  ASSERT_EQ(room.listener.warnings.size(), 1u);
  EXPECT_NE(room.listener.warnings[0].find("lights nothing"), std::string::npos) << room.listener.warnings[0];
}

TEST(ReflectionProbes, ALongBoxSeesWhatIsNearItsOrigin) {
  // The near distance follows the shortest side: a ball around the origin hides everything else.
  const LitRoom room;
  room.probe->SetBounds(-2, 2, -1, 1, -140, 160);
  room.probe->SetOrigin(0, 0, 0);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.05);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(16);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> around;
  around->SetMapper(mapper);
  makeUnlit(around, 1.0, 0.0, 0.75);
  room.renderer->AddActor(around);
  expectNear(room.mirrored(), {255, 0, 191}, 2);
  EXPECT_TRUE(room.listener.errors.empty()) << room.listener.errors.front();
}

TEST(ReflectionProbes, DataSetsAndLevelsOfDetailReflect) {
  const LitRoom room;
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(room.floor->GetMapper()->GetInputConnection(0, 0));
  room.floor->SetMapper(mapper);
  expectNear(room.mirrored(), {128, 128, 128}, 2);
  vtkNew<vtkLODActor> levels;
  levels->SetMapper(plane({-2, -1, 2}, {2, -1, 2}, {-2, -1, -2})->GetMapper());
  makeMirror(levels);
  room.renderer->RemoveActor(room.floor);
  room.renderer->AddActor(levels);
  room.probes->SetSeenByProbes(levels, false);
  for (int frame = 0; frame < 4; ++frame) expectNear(room.mirrored(), {128, 128, 128}, 2);
  EXPECT_TRUE(room.listener.warnings.empty()) << room.listener.warnings.front();
  EXPECT_TRUE(room.listener.errors.empty()) << room.listener.errors.front();
}

/// Draws nothing that VTK's render passes could edit.
class SilentMapper : public vtkOpenGLPolyDataMapper {
 public:
  static SilentMapper* New() { VTK_STANDARD_NEW_BODY(SilentMapper); }
  vtkTypeMacro(SilentMapper, vtkOpenGLPolyDataMapper) void RenderPiece(vtkRenderer*, vtkActor*) override {}
};

TEST(ReflectionProbes, AMapperThatAsksForNoPassIsSaid) {
  const LitRoom room;
  vtkNew<SilentMapper> silent;
  vtkMapper* before = room.floor->GetMapper();
  silent->SetInputConnection(before->GetInputConnection(0, 0));
  room.floor->SetMapper(silent);
  for (int frame = 0; frame < 6; ++frame) room.picture();
  ASSERT_EQ(room.listener.warnings.size(), 1u);
  EXPECT_NE(room.listener.warnings[0].find("SilentMapper reflects nothing"), std::string::npos)
      << room.listener.warnings[0];
  EXPECT_TRUE(room.listener.errors.empty());
}

TEST(ReflectionProbes, SeveralRenderersOfAWindowHaveTheirOwn) {
  LitRoom room;
  vtkNew<vtkRenderer> second;
  vtkSmartPointer<vtkActor> floor = plane({-2, -1, 2}, {2, -1, 2}, {-2, -1, -2});
  vtkSmartPointer<vtkActor> wall = plane({-2, -1, -2}, {2, -1, -2}, {-2, 1, -2});
  makeMirror(floor);
  makeUnlit(wall, 1, 0.5, 0);
  second->AddActor(floor);
  second->AddActor(wall);
  room.look(second, 0.0);
  room.window->SetSize(320, 160);
  room.renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  room.window->AddRenderer(second);
  vtkNew<vtkReflectionProbe> probe;
  probe->SetBounds(-2, 2, -1, 1, -2, 2);
  probe->SetFaceSize(64);
  vtkNew<vtkReflectionProbes> probes;
  const Listener listener(probes);
  probes->SetRenderer(second);
  probes->AddProbe(probe);
  probes->SetSeenByProbes(floor, false);
  ImageRgba8 both;
  for (int frame = 0; frame < 2; ++frame) both = room.picture();
  keepPicture(both, "probes_two_renderers");
  expectNear(at(both, kMirroredX, kMirroredY), {128, 128, 128}, 2);
  expectNear(at(both, 160 + kMirroredX, kMirroredY), {255, 128, 0}, 2);
  EXPECT_EQ(room.listener.starts, 1);
  EXPECT_EQ(listener.starts, 1);
  probes->SetRenderer(nullptr);
  room.window->RemoveRenderer(second);
}

TEST(ReflectionProbes, AnEnvironmentNeedsNoProbe) {
  Room room;
  vtkNew<vtkReflectionProbes> probes;
  probes->SetRenderer(room.renderer);
  vtkActor* wall = room.others[2];
  wall->VisibilityOff();
  expectNear(at(room.picture(), kMirroredX, kMirroredY), {0, 0, 0}, 0);
  EXPECT_STREQ(probes->GetLastError(), "");
}

TEST(ReflectionProbes, UnusedPropsAreVtksOwn) {
  Room room;
  const ImageRgba8 stock = room.picture();
  vtkNew<vtkReflectionProbe> probe;
  probe->SetBounds(-2, 2, -1, 1, -2, 2);
  vtkNew<vtkReflectionProbes> probes;
  probes->SetRenderer(room.renderer);
  probes->AddProbe(probe);
  probes->SetUsed(room.floor, false);
  EXPECT_EQ(room.picture().pixels, stock.pixels);
  EXPECT_FALSE(probes->GetUsed(room.floor));
  EXPECT_TRUE(probes->GetUsed(room.others[0]));
}

TEST(ReflectionProbes, BakedFilesTakeThePlaceOfCaptures) {
  ScenePicture baked = ScenePicture::fromFile("scenes/room.boxprobe.json", 64, 36);
  baked.show(baked.scene.cameras.front());
  const std::string file = baked.renderer->saveBaked("room", testing::TempDir(), "a test");
  const LitRoom room;
  room.picture();
  EXPECT_FALSE(room.probes->LoadMaps(room.probe, "missing.exr"));
  const ImageRgba8 captured = room.picture();
  ASSERT_TRUE(room.probes->LoadMaps(room.probe, file.c_str())) << room.probes->GetLastError();
  EXPECT_GT(meanDifference(captured, room.picture()), 5.0);
  room.others[2]->GetProperty()->SetColor(0, 1, 0);
  EXPECT_FALSE(room.probes->GetStale());
  room.others[2]->GetProperty()->SetColor(0.5, 0.5, 0.5);
  room.probes->ForgetMaps(room.probe);
  EXPECT_TRUE(room.probes->GetStale());
  EXPECT_EQ(room.picture().pixels, captured.pixels);
}

TEST(ReflectionProbes, ValuesComeBackFromTheLibrariesOwn) {
  vtkNew<vtkReflectionProbe> probe, same;
  probe->SetBounds(0, 1, 2, 4, 5, 8);
  probe->SetOrientation(10, 20, 30);
  probe->SetInfluenceBounds(-1, 2, 1, 5, 4, 9);
  probe->UseInfluenceBoundsOn();
  probe->SetBlendDistances(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
  probe->SetImportance(3);
  probe->SetIntensity(0.5);
  probe->SetTechnique("sphere");
  probe->SetFaceSize(128);
  probe->SetBounces(3);
  probe->SetSamplesPerPixel(16);
  probe->SetNearDistance(0.2);
  probe->SetClear(vtkReflectionProbe::COLOR);
  probe->SetClearColor(0.5, 0.25, 1.0);
  same->FromProbe(probe->ToProbe("hall"));
  EXPECT_EQ(same->ToProbe("hall"), probe->ToProbe("hall"));
  EXPECT_STREQ(same->GetName(), "hall");
  EXPECT_TRUE(same->GetOriginAtCenter());
  probe->SetOrigin(0.5, 3, 6);
  probe->SetClear(vtkReflectionProbe::OPEN);
  same->FromProbe(probe->ToProbe("hall"));
  EXPECT_EQ(same->ToProbe("hall"), probe->ToProbe("hall"));
}

TEST(ReflectionProbes, PrintThemselves) {
  const LitRoom room;
  room.probe->SetName("hall");
  room.probe->SetTechnique("sphere");
  std::ostringstream text;
  room.probes->Print(text);
  for (const char* part : {"AutoUpdate: 1", "Probes: 1", "Name: hall", "Technique: sphere", "Bounds: -2 2 -1 1 -2 2"}) {
    EXPECT_NE(text.str().find(part), std::string::npos) << part << " in\n" << text.str();
  }
  EXPECT_GE(room.probes->GetMTime(), room.probe->GetMTime());
  EXPECT_GE(BOXPROBE_VERSION_NUMBER, BOXPROBE_VERSION_CHECK(0, 1, 0));
}

TEST(ReflectionProbes, TheExampleDrawsAMirrorFloor) {
  const std::string file = testing::TempDir() + "probes_in_renderer.png";
  ASSERT_EQ(std::system((std::string(BOXPROBE_PROBES_EXAMPLE) + " " + file).c_str()), 0);
  const ImageRgba8 picture = loadImage8(file);
  keepPicture(picture, "probes_example");
  ASSERT_EQ(picture.width, 640);
  // The back wall and its image in the floor: yellow both.
  const auto wall = at(picture, 320, 120), mirrored = at(picture, 320, 280);
  EXPECT_GT(wall[0], wall[2] + 30);
  EXPECT_GT(mirrored[0], mirrored[2] + 20);
}

}  // namespace
