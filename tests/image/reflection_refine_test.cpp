// Refinement at rest in a renderer of a program's own: where it ends, what begins and ends it, and what it leaves
// alone. The judge is the integral over the lobe, summed here from the walls' colours.
#include <vtkCallbackCommand.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkWindowToImageFilter.h>

#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/actors/vtkReflectionProbes.h"
#include "tests/image/vtk_room.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr double kRoughness = 0.45;

struct Heard {
  explicit Heard(vtkObject* object) {
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long event, void* client, void* data) {
      auto* self = static_cast<Heard*>(client);
      if (event == vtkReflectionProbes::EndRefineEvent) ++self->ends;
      if (event == vtkCommand::WarningEvent) self->warnings.emplace_back(static_cast<const char*>(data));
      if (event == vtkCommand::ErrorEvent) self->errors.emplace_back(static_cast<const char*>(data));
    });
    object->AddObserver(vtkCommand::AnyEvent, command);
  }
  vtkNew<vtkCallbackCommand> command;
  int ends = 0;
  std::vector<std::string> warnings, errors;
};

/// The room with a floor of rough metal.
struct RoughRoom : Room {
  RoughRoom() {
    floor->GetProperty()->SetRoughness(kRoughness);
    look(renderer, 0.3);
    probe->SetBounds(-2, 2, -1, 1, -2, 2);
    probe->SetFaceSize(128);
    probe->SetTechnique("box");
    probes->SetRenderer(renderer);
    probes->AddProbe(probe);
    probes->SetSeenByProbes(floor, false);
  }
  int refine() const {
    int frames = 1;
    while (probes->RefineStep()) ++frames;
    return frames;
  }

  vtkNew<vtkReflectionProbe> probe;
  vtkNew<vtkReflectionProbes> probes;
  Heard heard{probes};
};

glm::dvec3 wallLight(const glm::dvec3& from, const glm::dvec3& along) {
  const glm::dvec3 size(2.0, 1.0, 2.0);
  int axis = 0;
  double nearest = 1e300;
  for (int a = 0; a < 3; ++a) {
    const double t = along[a] == 0.0 ? 1e300 : ((along[a] > 0.0 ? size[a] : -size[a]) - from[a]) / along[a];
    if (t < nearest) {
      nearest = t;
      axis = a;
    }
  }
  const double grey = std::pow(0.5, 2.2);
  if (axis == 0) return along.x < 0.0 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  if (axis == 1) return glm::dvec3(1.0);
  return along.z < 0.0 ? glm::dvec3(grey) : glm::dvec3(0, 0, 1);
}

/// GGX with height-correlated Smith masking, F = 1, over the upper hemisphere, on a fine grid of half vectors.
glm::dvec3 reflected(const glm::dvec3& at, const glm::dvec3& view) {
  const double alpha = kRoughness * kRoughness, a2 = alpha * alpha;
  const auto lambda = [&](double c) { return 0.5 * (std::sqrt(1.0 + a2 * (1.0 / (c * c) - 1.0)) - 1.0); };
  constexpr int kRings = 160, kTurns = 320;
  glm::dvec3 sum(0.0);
  for (int i = 0; i < kRings; ++i) {
    // Equal shares of D cos, by its inverse.
    const double u = (i + 0.5) / kRings, c = std::sqrt((1.0 - u) / (1.0 + (a2 - 1.0) * u)), s = std::sqrt(1.0 - c * c);
    for (int k = 0; k < kTurns; ++k) {
      const double turn = 2.0 * vtkMath::Pi() * (k + 0.5) / kTurns;
      const glm::dvec3 half(s * std::cos(turn), c, s * std::sin(turn));
      const double vh = glm::dot(view, half);
      const glm::dvec3 light = 2.0 * vh * half - view;
      if (vh <= 0.0 || light.y <= 0.0) continue;
      const double masking = 1.0 / (1.0 + lambda(view.y) + lambda(light.y));
      sum += wallLight(at, light) * (masking * vh / (view.y * c));
    }
  }
  return sum / static_cast<double>(kRings * kTurns);
}

/// RMS distance of the floor's pixels from the integral, in steps of 8 bits.
double floorError(const Room& room, const ImageRgba8& picture) {
  vtkCamera* camera = room.renderer->GetActiveCamera();
  const glm::dvec3 eye(camera->GetPosition()[0], camera->GetPosition()[1], camera->GetPosition()[2]);
  const glm::dvec3 to(camera->GetFocalPoint()[0], camera->GetFocalPoint()[1], camera->GetFocalPoint()[2]);
  const glm::dvec3 ahead = glm::normalize(to - eye), right = glm::normalize(glm::cross(ahead, glm::dvec3(0, 1, 0)));
  const glm::dvec3 up = glm::cross(right, ahead);
  const double half = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  double squares = 0.0;
  int count = 0;
  for (int y = 118; y < 158; y += 9) {
    for (int x = 7; x < 155; x += 13) {
      const double across = (x + 0.5) / 80.0 - 1.0, above = 1.0 - (y + 0.5) / 80.0;
      const glm::dvec3 ray = glm::normalize(ahead + half * (across * right + above * up));
      const glm::dvec3 point = eye + ray * ((-1.0 - eye.y) / ray.y);
      if (std::abs(point.x) > 1.98 || std::abs(point.z) > 1.98) continue;
      const glm::dvec3 light = reflected(point, -ray);
      const auto shown = at(picture, x, y);
      for (int c = 0; c < 3; ++c) {
        const double wanted = 255.0 * std::pow(std::min(light[c], 1.0), 1.0 / 2.2);
        squares += (shown[static_cast<std::size_t>(c)] - wanted) * (shown[static_cast<std::size_t>(c)] - wanted);
        ++count;
      }
    }
  }
  EXPECT_GT(count, 100);
  return std::sqrt(squares / count);
}

TEST(ReflectionRefine, GoesOnToTheIntegralAndEnds) {
  const RoughRoom room;
  const ImageRgba8 own = room.picture();
  EXPECT_FALSE(room.probes->RefineStep());  // off
  EXPECT_FALSE(room.probes->GetRefining());
  room.probes->RefineAtRestOn();
  EXPECT_EQ(room.picture().pixels, own.pixels);  // not before it is asked
  const int frames = room.refine();
  const ImageRgba8 refined = windowPixels(room.window);
  const double before = floorError(room, own), after = floorError(room, refined);
  std::printf("%d frames: %.2f to %.2f steps of 8 bits; left %.4f\n", frames, before, after,
              room.probes->GetRefineLeft());
  EXPECT_LT(after, 0.5 * before);
  EXPECT_LT(after, 3.0);
  EXPECT_GE(room.probes->GetRefineLeft(), 0.0);
  EXPECT_EQ(room.heard.ends, 1);
  EXPECT_TRUE(room.probes->GetRefining());
  EXPECT_DOUBLE_EQ(room.probes->GetRefineProgress(), 1.0);
  // Once done it is only shown.
  EXPECT_FALSE(room.probes->RefineStep());
  EXPECT_EQ(room.picture().pixels, refined.pixels);
  EXPECT_EQ(room.heard.ends, 1);
  expectNear(at(refined, 80, 40), at(own, 80, 40), 1);  // an unlit wall
  EXPECT_TRUE(room.heard.errors.empty()) << room.heard.errors.front();
  EXPECT_TRUE(room.heard.warnings.empty()) << room.heard.warnings.front();
}

// The filter draws the window once more, with a view angle that went through a sine and back.
TEST(ReflectionRefine, ASavedPictureIsTheRefinedOne) {
  const RoughRoom room;
  room.probes->RefineAtRestOn();
  for (const double angle : {60.0, 47.0, 33.0}) {
    room.renderer->GetActiveCamera()->SetViewAngle(angle);
    const ImageRgba8 own = room.picture();
    room.refine();
    const ImageRgba8 refined = windowPixels(room.window);
    EXPECT_GT(meanDifference(refined, own), 0.0) << angle;
    vtkNew<vtkWindowToImageFilter> saved;
    saved->SetInput(room.window);
    saved->ReadFrontBufferOff();
    saved->Update();
    EXPECT_TRUE(room.probes->GetRefining()) << angle;
    vtkImageData* image = saved->GetOutput();
    const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
    const auto width = static_cast<std::size_t>(refined.width), height = static_cast<std::size_t>(refined.height);
    ASSERT_EQ(static_cast<std::size_t>(image->GetNumberOfPoints()), width * height);
    ASSERT_EQ(image->GetNumberOfScalarComponents(), 3);
    std::size_t different = 0;
    for (std::size_t i = 0; i < width * height; ++i) {
      const std::size_t from = (height - 1 - i / width) * width + i % width;  // the filter's rows go up
      for (std::size_t c = 0; c < 3; ++c) different += pixels[3 * from + c] != refined.pixels[4 * i + c] ? 1 : 0;
    }
    EXPECT_EQ(different, 0u) << angle;
  }
}

// VTK draws such a picture in parts.
TEST(ReflectionRefine, ALargerSavedPictureShowsEachPartInItsPlace) {
  const RoughRoom room, plain;
  room.probes->RefineAtRestOn();
  room.picture();
  room.refine();
  plain.picture();
  const auto saved = [](vtkRenderWindow* window) {
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(window);
    filter->SetScale(3, 2);
    filter->ReadFrontBufferOff();
    filter->Update();
    vtkImageData* image = filter->GetOutput();
    const auto* pixels = static_cast<const unsigned char*>(image->GetScalarPointer());
    return std::vector<unsigned char>(pixels, pixels + 3 * image->GetNumberOfPoints());
  };
  const std::vector<unsigned char> of = saved(room.window), own = saved(plain.window);
  ASSERT_EQ(of.size(), own.size());
  std::size_t apart = 0;
  for (std::size_t i = 0; i < of.size(); ++i) apart += std::abs(of[i] - own[i]) > 12 ? 1 : 0;
  EXPECT_LT(apart, of.size() / 50);
}

TEST(ReflectionRefine, WhateverMovesIsDrawnByTheTechniqueAgain) {
  const RoughRoom room, plain;
  room.probes->RefineAtRestOn();
  const auto same = [&](const char* what) {
    EXPECT_GT(meanDifference(room.picture(), plain.picture()), 0.0) << what << ": was not refined before";
  };
  room.refine();
  same("first");
  const auto moves = [&](const char* what, const auto& change) {
    for (const RoughRoom* one : {&room, &plain}) change(*one);
    EXPECT_EQ(room.picture().pixels, plain.picture().pixels) << what;
    EXPECT_FALSE(room.probes->GetRefining()) << what;
    room.refine();
    same(what);
  };
  moves("camera", [](const RoughRoom& one) { one.look(one.renderer, -0.2); });
  moves("view angle", [](const RoughRoom& one) { one.renderer->GetActiveCamera()->SetViewAngle(50); });
  moves("window centre", [](const RoughRoom& one) { one.renderer->GetActiveCamera()->SetWindowCenter(0.25, -0.125); });
  moves("colour", [](const RoughRoom& one) { one.others[2]->GetProperty()->SetColor(0.25, 0.5, 0.75); });
  moves("roughness", [](const RoughRoom& one) { one.floor->GetProperty()->SetRoughness(0.3); });
  moves("box", [](const RoughRoom& one) { one.probe->SetBounds(-2, 2, -1, 1, -2, 2.4); });
  moves("exposure", [](const RoughRoom& one) { one.probes->SetExposure(0.8); });
  moves("hidden", [](const RoughRoom& one) { one.others[1]->VisibilityOff(); });
  EXPECT_EQ(room.heard.ends, 9);
  room.probes->RefineAtRestOff();
  EXPECT_EQ(room.picture().pixels, plain.picture().pixels);
  EXPECT_TRUE(room.heard.errors.empty()) << room.heard.errors.front();
}

TEST(ReflectionRefine, EndsWhereItIsTold) {
  const RoughRoom room;
  room.probes->RefineAtRestOn();
  room.probes->SetRefineRays(16);
  const int few = room.refine();
  room.probes->SetRefineRays(1000000);
  EXPECT_EQ(room.probes->GetRefineRays(), 16384);
  room.probes->SetRefineRays(-3);
  EXPECT_EQ(room.probes->GetRefineRays(), 1);
  room.probes->SetRefineSeconds(-1.0);
  EXPECT_DOUBLE_EQ(room.probes->GetRefineSeconds(), 0.0);
  room.probes->SetRefineRays(16384);
  room.probes->SetRefineSeconds(1.0e-6);
  EXPECT_LT(room.refine(), few);
  EXPECT_EQ(room.heard.ends, 2);
  EXPECT_DOUBLE_EQ(room.probes->GetRefineProgress(), 1.0);
}

/// As a program's own loop has it: timers that the test lets run out.
class Timers : public vtkGenericRenderWindowInteractor {
 public:
  static Timers* New() { VTK_STANDARD_NEW_BODY(Timers); }
  int made = 0, running = 0;
  std::vector<unsigned long> delays;
  bool fire() {
    if (running == 0) return false;
    int timer = running;
    running = 0;
    this->InvokeEvent(vtkCommand::TimerEvent, &timer);
    return true;
  }

 protected:
  int InternalCreateTimer(int id, int, unsigned long duration) override {
    ++made;
    running = id;
    delays.push_back(duration);
    return id;
  }
  int InternalDestroyTimer(int) override {
    running = 0;
    return 1;
  }
};

TEST(ReflectionRefine, TheInteractorsTimerTakesTheSteps) {
  const RoughRoom room, plain;
  vtkNew<Timers> loop;
  loop->SetRenderWindow(room.window);
  loop->SetEnableRender(false);
  loop->Initialize();
  room.picture();
  EXPECT_EQ(loop->made, 0);  // off
  room.probes->RefineAtRestOn();
  room.probes->SetRefineDelay(0.75);
  room.picture();
  ASSERT_EQ(loop->delays, std::vector<unsigned long>{750});
  EXPECT_EQ(windowPixels(room.window).pixels, plain.picture().pixels);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(loop->fire());
  EXPECT_TRUE(room.probes->GetRefining());
  // Moved meanwhile: the technique's own at once, and the wait from the beginning.
  for (const RoughRoom* one : {&room, &plain}) one->look(one->renderer, -0.2);
  EXPECT_EQ(room.picture().pixels, plain.picture().pixels);
  EXPECT_EQ(loop->delays.back(), 750u);
  int steps = 0;
  while (loop->fire()) ++steps;
  std::printf("%d steps by timers\n", steps);
  EXPECT_GT(steps, 10);
  EXPECT_EQ(room.heard.ends, 1);
  EXPECT_EQ(loop->running, 0);  // costs nothing once done
  // None is left behind.
  room.look(room.renderer, 0.1);
  room.picture();
  EXPECT_NE(loop->running, 0);
  room.probes->SetRenderer(nullptr);
  EXPECT_EQ(loop->running, 0);
  room.window->SetInteractor(nullptr);
}

TEST(ReflectionRefine, AViewThatNeverRestsEndsEachTime) {
  const RoughRoom room;
  room.probes->RefineAtRestOn();
  vtkNew<vtkCallbackCommand> turn;
  turn->SetClientData(room.renderer);
  turn->SetCallback([](vtkObject*, unsigned long, void* client, void*) {
    static_cast<vtkRenderer*>(client)->GetActiveCamera()->Azimuth(1.5);
  });
  room.window->AddObserver(vtkCommand::StartEvent, turn);
  EXPECT_EQ(room.refine(), 2);
  EXPECT_EQ(room.heard.ends, 0);
  room.window->RemoveObserver(turn);
  room.refine();
  EXPECT_EQ(room.heard.ends, 1);
}

TEST(ReflectionRefine, APartOfTheWindowLeavesTheRest) {
  const RoughRoom room;
  room.window->SetSize(200, 150);
  room.renderer->SetViewport(0.2, 0.1, 0.9, 0.8);
  room.renderer->SetBackground(0.2, 0.4, 0.6);
  room.others[4]->VisibilityOff();  // the background shows above
  vtkNew<vtkRenderer> beside;
  beside->SetViewport(0.0, 0.0, 0.2, 1.0);
  beside->SetBackground(0.7, 0.1, 0.3);
  for (const auto& wall : room.others) beside->AddActor(wall);
  beside->AddActor(room.floor);
  room.look(beside, 0.7);
  room.window->AddRenderer(beside);
  const ImageRgba8 own = room.picture();
  room.probes->RefineAtRestOn();
  room.refine();
  const ImageRgba8 refined = windowPixels(room.window);
  const std::array<int, 3> behind{51, 102, 153};
  const auto around = [&](int x, int y) {
    for (int i = 0; i < 9; ++i) {
      if (at(own, x + i % 3 - 1, y + i / 3 - 1) != behind) return false;
    }
    return true;
  };
  int outside = 0, background = 0, lit = 0;
  for (int y = 0; y < own.height; ++y) {
    for (int x = 0; x < own.width; ++x) {
      const auto was = at(own, x, y), is = at(refined, x, y);
      const bool within = x >= 40 && x < 180 && y >= 30 && y < 135;
      if (!within) {
        outside += was != is ? 1 : 0;
      } else if (was == behind) {
        ++background;
        // Edges are averaged over a pixel's area.
        if (around(x, y)) {
          EXPECT_EQ(is, was) << x << ", " << y;
        }
      } else {
        lit += was != is ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(outside, 0);
  EXPECT_GT(background, 500);
  EXPECT_GT(lit, 500);
  EXPECT_TRUE(room.heard.errors.empty()) << room.heard.errors.front();
  room.window->RemoveRenderer(beside);
}

TEST(ReflectionRefine, WhatAveragedFramesGoWithoutIsKept) {
  const RoughRoom room;
  room.renderer->UseFXAAOn();
  room.probes->RefineAtRestOn();
  const ImageRgba8 own = room.picture();
  EXPECT_FALSE(room.probes->RefineStep());
  EXPECT_FALSE(room.probes->RefineStep());
  EXPECT_EQ(windowPixels(room.window).pixels, own.pixels);
  ASSERT_EQ(room.heard.warnings.size(), 1u);
  EXPECT_NE(room.heard.warnings[0].find("UseFXAA"), std::string::npos) << room.heard.warnings[0];
  room.renderer->UseFXAAOff();
  EXPECT_TRUE(room.probes->RefineStep());
}

}  // namespace
