// vtkReflectionProbeWidget in a plain VTK program: real events of an interactor at pixels that this file projects by
// itself, and what becomes of the probe, of the captures and of the picture.
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRendererCollection.h>
#include <vtkTransform.h>
#include <vtkWeakPointer.h>

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <sstream>

#include "filters/io/image/image_file.h"
#include "filters/vtk/actors/vtkReflectionProbe.h"
#include "filters/vtk/actors/vtkReflectionProbes.h"
#include "filters/vtk/widgets/vtkReflectionProbeRepresentation.h"
#include "filters/vtk/widgets/vtkReflectionProbeWidget.h"
#include "tests/image/vtk_room.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;
using Shown = vtkReflectionProbeRepresentation;

struct Counts {
  explicit Counts(vtkObject* object) : watched(object) {
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long event, void* client, void*) {
      auto* self = static_cast<Counts*>(client);
      if (event == vtkCommand::StartInteractionEvent) ++self->started;
      if (event == vtkCommand::InteractionEvent) ++self->moved;
      if (event == vtkCommand::EndInteractionEvent) ++self->ended;
      if (event == vtkCommand::StartEvent) ++self->captures;
      if (event == vtkCommand::ErrorEvent) ++self->errors;
    });
    object->AddObserver(vtkCommand::AnyEvent, command);
  }
  ~Counts() {
    if (watched) watched->RemoveObserver(command);
  }
  Counts(const Counts&) = delete;
  Counts& operator=(const Counts&) = delete;

  vtkWeakPointer<vtkObject> watched;
  vtkNew<vtkCallbackCommand> command;
  int started = 0, moved = 0, ended = 0, captures = 0, errors = 0;
};

/// World of a point that is given as if the box were not turned.
glm::dvec3 turnedPoint(vtkReflectionProbe* probe, const glm::dvec3& p) {
  const double* b = probe->GetBounds();
  const double* angles = probe->GetOrientation();
  const double center[3] = {0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5])};
  vtkNew<vtkTransform> turn;
  turn->Translate(center);
  turn->RotateZ(angles[2]);
  turn->RotateY(angles[1]);
  turn->RotateX(angles[0]);
  turn->Translate(-center[0], -center[1], -center[2]);
  const double* at = turn->TransformPoint(p.x, p.y, p.z);
  return {at[0], at[1], at[2]};
}

glm::dvec3 faceCenter(vtkReflectionProbe* probe, const double* bounds, int face) {
  glm::dvec3 p(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[4] + bounds[5]));
  p[face / 2] = bounds[face];
  return turnedPoint(probe, p);
}

/// Out of the box.
glm::dvec3 faceNormal(vtkReflectionProbe* probe, int face) {
  glm::dvec3 axis(0.0);
  axis[face / 2] = face % 2 == 1 ? 1.0 : -1.0;
  return turnedPoint(probe, axis) - turnedPoint(probe, glm::dvec3(0.0));
}

/// Where the planes of the six faces are along their normals.
std::array<double, 6> planes(vtkReflectionProbe* probe, const double* bounds) {
  std::array<double, 6> at{};
  for (int face = 0; face < 6; ++face) {
    at[static_cast<std::size_t>(face)] = glm::dot(faceCenter(probe, bounds, face), faceNormal(probe, face));
  }
  return at;
}

/// A room of its own in a part of the window, with a probe that is no wall's, off its middle and turned.
struct Stage : Room {
  Stage() {
    window->SetSize(640, 480);
    renderer->SetViewport(0.05, 0.1, 0.95, 0.92);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(2.9, 2.3, 5.6);
    camera->SetFocalPoint(0.1, -0.1, 0.2);
    camera->SetViewAngle(33);
    camera->SetClippingRange(0.05, 40);
    others[3]->VisibilityOff();  // the wall at +z and the ceiling, which the camera is behind
    others[4]->VisibilityOff();
    others[1]->VisibilityOff();
    probe->SetBounds(-1.3, 1.1, -0.8, 0.6, -1.2, 0.9);
    probe->SetOrigin(0.2, -0.3, 0.1);
    probe->SetOrientation(4, 17, -3);
    probe->SetFaceSize(64);
    probes->SetRenderer(renderer);
    probes->AddProbe(probe);
    interactor->SetRenderWindow(window);
    widget->SetInteractor(interactor);
    widget->SetProbe(probe);
  }
  /// As most tests want it: enabled, drawn once.
  void start() {
    widget->On();
    window->Render();
  }
  Shown* shown() const { return widget->GetReflectionProbeRepresentation(); }

  /// Display coordinates, by VTK's own matrices.
  glm::dvec2 display(const glm::dvec3& p, vtkRenderer* by = nullptr) const {
    vtkRenderer* through = by != nullptr ? by : renderer.Get();
    const int* size = through->GetSize();
    const int* origin = through->GetOrigin();
    vtkMatrix4x4* matrix =
        through->GetActiveCamera()->GetCompositeProjectionTransformMatrix(double(size[0]) / size[1], -1, 1);
    const double in[4] = {p.x, p.y, p.z, 1.0};
    double clip[4];
    matrix->MultiplyPoint(in, clip);
    return {origin[0] + 0.5 * size[0] * (1.0 + clip[0] / clip[3]),
            origin[1] + 0.5 * size[1] * (1.0 + clip[1] / clip[3])};
  }
  /// World length of a pixel there.
  double unitsPerPixel(const glm::dvec3& p) const {
    vtkCamera* camera = renderer->GetActiveCamera();
    double direction[3], position[3];
    camera->GetDirectionOfProjection(direction);
    camera->GetPosition(position);
    const glm::dvec3 forward(direction[0], direction[1], direction[2]);
    const double depth = glm::dot(p - glm::dvec3(position[0], position[1], position[2]), forward);
    return depth * std::tan(glm::radians(0.5 * camera->GetViewAngle())) / (0.5 * renderer->GetSize()[1]);
  }

  struct Keys {
    bool control = false, shift = false, alt = false;
  };
  void send(unsigned long event, const glm::dvec2& at, const Keys& keys) const {
    interactor->SetEventInformation(static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y)),
                                    keys.control ? 1 : 0, keys.shift ? 1 : 0);
    interactor->SetAltKey(keys.alt ? 1 : 0);
    interactor->InvokeEvent(event);
  }
  void press(const glm::dvec2& at, const Keys& keys) const {
    send(vtkCommand::MouseMoveEvent, at, keys);
    send(vtkCommand::LeftButtonPressEvent, at, keys);
  }
  static constexpr int kMoves = 4;
  void lead(const glm::dvec2& from, const glm::dvec2& to, const Keys& keys) const {
    for (int i = 1; i <= kMoves; ++i) {
      send(vtkCommand::MouseMoveEvent, from + (to - from) * (double(i) / kMoves), keys);
      window->Render();
    }
  }
  void drag(const glm::dvec2& from, const glm::dvec2& to, const Keys& keys) const {
    press(from, keys);
    lead(from, to, keys);
    send(vtkCommand::LeftButtonReleaseEvent, to, keys);
  }
  void drag(const glm::dvec2& from, const glm::dvec2& to) const { drag(from, to, Keys()); }
  /// World length along the way from `a` to `b` that a pixel at either end stands for, and half of one more.
  double tolerance(const glm::dvec3& a, const glm::dvec3& b) const {
    return 1.5 * glm::length(b - a) / glm::length(display(b) - display(a));
  }
  /// Without the handles.
  ImageRgba8 bare() const {
    shown()->VisibilityOff();
    const ImageRgba8 image = picture();
    shown()->VisibilityOn();
    return image;
  }

  vtkNew<vtkReflectionProbe> probe;
  vtkNew<vtkReflectionProbes> probes;
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkReflectionProbeWidget> widget;
  Counts counts{widget};
  Counts captures{probes};
};

TEST(ProbeWidget, EachFaceGoesAsFarAsThePointerAndNothingIsCaptured) {
  Stage stage;
  stage.start();
  ASSERT_EQ(stage.captures.captures, 1);
  for (int face = 0; face < 6; ++face) {
    SCOPED_TRACE(face);
    for (const double out : {0.37, -0.52}) {
      const auto before = planes(stage.probe, stage.probe->GetBounds());
      const glm::dvec3 from = faceCenter(stage.probe, stage.probe->GetBounds(), face);
      const glm::dvec3 to = from + out * faceNormal(stage.probe, face);
      const int started = stage.counts.started, moved = stage.counts.moved, ended = stage.counts.ended;
      stage.drag(stage.display(from), stage.display(to));
      EXPECT_EQ(stage.shown()->GetInteractionFace(), face);
      EXPECT_EQ(stage.counts.started, started + 1);
      EXPECT_EQ(stage.counts.moved, moved + Stage::kMoves);
      EXPECT_EQ(stage.counts.ended, ended + 1);
      const auto after = planes(stage.probe, stage.probe->GetBounds());
      for (int other = 0; other < 6; ++other) {
        const auto i = static_cast<std::size_t>(other);
        EXPECT_NEAR(after[i] - before[i], other == face ? out : 0.0, other == face ? stage.tolerance(from, to) : 1e-9);
      }
      EXPECT_EQ(stage.probe->GetOrigin()[0], 0.2);
      EXPECT_EQ(stage.probe->GetOrigin()[1], -0.3);
      EXPECT_EQ(stage.probe->GetOrigin()[2], 0.1);
    }
  }
  stage.window->Render();
  EXPECT_EQ(stage.captures.captures, 1) << "a box is uniforms";
  EXPECT_EQ(stage.captures.errors, 0);
}

TEST(ProbeWidget, ADraggedFaceShowsInTheNextFrame) {
  Stage stage;
  stage.probe->SetOrientation(0, 0, 0);
  stage.probe->SetBounds(-1.9, 1.7, -1.1, 0.9, -2, 1.8);
  stage.start();
  const ImageRgba8 before = stage.bare();
  const glm::dvec3 from = faceCenter(stage.probe, stage.probe->GetBounds(), 4);
  stage.drag(stage.display(from), stage.display(from + glm::dvec3(0, 0, 0.8)));
  EXPECT_GT(meanDifference(before, stage.bare()), 0.5) << "the floor reflects another box";
  EXPECT_EQ(stage.captures.captures, 1);
}

TEST(ProbeWidget, TheOriginGoesWithThePointerAndIsCapturedAgain) {
  Stage stage;
  stage.start();
  const glm::dvec3 from(0.2, -0.3, 0.1);
  double direction[3];
  stage.renderer->GetActiveCamera()->GetDirectionOfProjection(direction);
  const glm::dvec3 forward(direction[0], direction[1], direction[2]);
  const glm::dvec3 to =
      from + 0.3 * glm::normalize(glm::cross(forward, glm::dvec3(0.3, 1.0, 0.1)));  // in the view's plane
  const std::array<double, 6> bounds = {-1.3, 1.1, -0.8, 0.6, -1.2, 0.9};
  stage.drag(stage.display(from), stage.display(to));
  EXPECT_EQ(stage.counts.started, 1);
  EXPECT_EQ(stage.counts.ended, 1);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(stage.probe->GetOrigin()[axis], to[axis], stage.tolerance(from, to));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(stage.probe->GetBounds()[i], bounds[i]);
  EXPECT_FALSE(stage.probe->GetOriginAtCenter());
  EXPECT_GT(stage.captures.captures, 1);
}

TEST(ProbeWidget, AnOriginAtTheCentreStaysThere) {
  Stage stage;
  stage.probe->SetOriginAtCenter(true);
  stage.start();
  const glm::dvec3 from = faceCenter(stage.probe, stage.probe->GetBounds(), 1);
  const glm::dvec3 to = from + 0.4 * faceNormal(stage.probe, 1);
  stage.drag(stage.display(from), stage.display(to));
  const double* b = stage.probe->GetBounds();
  EXPECT_TRUE(stage.probe->GetOriginAtCenter());
  EXPECT_GT(b[1], 1.2);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_DOUBLE_EQ(stage.probe->GetOrigin()[axis], 0.5 * (b[2 * axis] + b[2 * axis + 1]));
  }
}

TEST(ProbeWidget, InfluenceAndBlendDistancesGoByTheirOwnHandles) {
  Stage stage;
  stage.probe->SetInfluenceBounds(-1.5, 1.4, -0.9, 0.9, -1.6, 1.3);
  stage.probe->UseInfluenceBoundsOn();
  stage.probe->SetBlendDistances(0.1, 0.3, 0.2, 0.25, 0.15, 0.4);
  stage.start();
  stage.shown()->SetModeToInfluence();
  const std::array<double, 6> bounds = {-1.3, 1.1, -0.8, 0.6, -1.2, 0.9};
  for (const int face : {1, 3, 5, 0}) {
    SCOPED_TRACE(face);
    double influence[6];
    stage.probe->GetInfluenceBounds(influence);
    const double was = influence[face];
    const glm::dvec3 from = faceCenter(stage.probe, influence, face), to = from + 0.33 * faceNormal(stage.probe, face);
    stage.drag(stage.display(from), stage.display(to));
    EXPECT_EQ(stage.shown()->GetInteractionState(), Shown::MovingInfluence);
    const double sign = face % 2 == 1 ? 1.0 : -1.0;
    EXPECT_NEAR(stage.probe->GetInfluenceBounds()[face] - was, 0.33 * sign, stage.tolerance(from, to));
  }
  for (const int face : {1, 5}) {
    SCOPED_TRACE(face);
    // A quarter of its width beside the middle of the face of the box of full weight.
    double inner[6];
    stage.probe->GetInfluenceBounds(inner);
    for (int i = 0; i < 6; ++i) inner[i] += (i % 2 == 0 ? 1.0 : -1.0) * stage.probe->GetBlendDistances()[i];
    const double was = stage.probe->GetBlendDistances()[face];
    glm::dvec3 p(0.5 * (inner[0] + inner[1]), 0.5 * (inner[2] + inner[3]), 0.5 * (inner[4] + inner[5]));
    p[face / 2] = inner[face];
    const int beside = (face / 2 + 1) % 3;
    p[beside] += 0.25 * (inner[2 * beside + 1] - inner[2 * beside]);
    const glm::dvec3 from = turnedPoint(stage.probe, p), to = from - 0.21 * faceNormal(stage.probe, face);
    stage.drag(stage.display(from), stage.display(to));
    EXPECT_EQ(stage.shown()->GetInteractionState(), Shown::MovingBlend);
    EXPECT_NEAR(stage.probe->GetBlendDistances()[face] - was, 0.21, stage.tolerance(from, to));
  }
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(stage.probe->GetBounds()[i], bounds[i]);
  EXPECT_EQ(stage.captures.captures, 1);
}

TEST(ProbeWidget, ArrowsMoveTheWholeProbeAndRingsTurnIt) {
  Stage stage;
  stage.probe->SetOrientation(0, 17, 0);
  stage.start();
  stage.shown()->SetModeToPlace();
  const auto center = [&stage] {
    const double* b = stage.probe->GetBounds();
    return glm::dvec3(0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]));
  };
  // The ring about Y has a radius of 66 pixels; taken between two arrows.
  const double radius = 66.0 * stage.unitsPerPixel(center());
  const glm::dvec3 u = faceNormal(stage.probe, 5), v = faceNormal(stage.probe, 1);
  const auto ring = [&](double degrees) {
    const double angle = glm::radians(degrees);
    return stage.display(center() + radius * (std::cos(angle) * u + std::sin(angle) * v));
  };
  stage.press(ring(40), {});
  EXPECT_EQ(stage.shown()->GetInteractionState(), Shown::Rotating);
  EXPECT_EQ(stage.shown()->GetInteractionAxis(), 1);
  for (const double degrees : {45.0, 52.0, 60.0, 71.0}) stage.send(vtkCommand::MouseMoveEvent, ring(degrees), {});
  stage.send(vtkCommand::LeftButtonReleaseEvent, ring(71), {});
  EXPECT_NEAR(stage.probe->GetOrientation()[1], 17.0 + 31.0, 2.0);
  EXPECT_EQ(stage.probe->GetOrientation()[0], 0.0);
  EXPECT_EQ(stage.probe->GetOrientation()[2], 0.0);

  const glm::dvec3 along = faceNormal(stage.probe, 1), was = center();
  const glm::dvec3 from = was + 60.0 * stage.unitsPerPixel(was) * along, to = from + 0.45 * along;
  const std::array<double, 3> origin = {stage.probe->GetOrigin()[0], stage.probe->GetOrigin()[1],
                                        stage.probe->GetOrigin()[2]};
  stage.drag(stage.display(from), stage.display(to));
  EXPECT_EQ(stage.shown()->GetInteractionState(), Shown::Translating);
  const glm::dvec3 by = center() - was;
  EXPECT_NEAR(glm::dot(by, along), 0.45, stage.tolerance(from, to));
  EXPECT_NEAR(glm::length(glm::cross(by, along)), 0.0, 1e-12);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(stage.probe->GetOrigin()[axis] - origin[static_cast<std::size_t>(axis)], by[axis], 1e-12);
  }
}

TEST(ProbeWidget, KeysSnapSlowDownAndMoveBothSides) {
  Stage stage;
  stage.probe->SetOrientation(0, 0, 0);
  stage.start();
  // Control: onto the wall at z = -2, at a pixel of that wall.
  const glm::dvec3 back = faceCenter(stage.probe, stage.probe->GetBounds(), 4);
  stage.drag(stage.display(back), stage.display({0.3, 0.75, -2}), {true, false, false});
  EXPECT_NEAR(stage.probe->GetBounds()[4], -2.0, 1e-6);
  // Without walls the grid, which is an odd step here.
  stage.shown()->SnapToSurfacesOff();
  stage.shown()->SetLargestGridStep(0.07);
  const glm::dvec3 right = faceCenter(stage.probe, stage.probe->GetBounds(), 1);
  stage.drag(stage.display(right), stage.display(right + glm::dvec3(0.33, 0, 0)), {true, false, false});
  const double steps = stage.probe->GetBounds()[1] / 0.07;
  EXPECT_NEAR(steps, std::round(steps), 1e-9);
  EXPECT_NEAR(stage.probe->GetBounds()[1], 1.43, 0.06);
  // Shift: a tenth as far.
  const double top = stage.probe->GetBounds()[3];
  const glm::dvec3 above = faceCenter(stage.probe, stage.probe->GetBounds(), 3), higher = above + glm::dvec3(0, 0.6, 0);
  stage.drag(stage.display(above), stage.display(higher), {false, true, false});
  EXPECT_NEAR(stage.probe->GetBounds()[3] - top, 0.06, 0.3 * stage.tolerance(above, higher) + 0.004);
  // Alt: the other side as well.
  double bounds[6];
  stage.probe->GetBounds(bounds);
  const glm::dvec3 left = faceCenter(stage.probe, bounds, 0), further = left - glm::dvec3(0.31, 0, 0);
  stage.drag(stage.display(left), stage.display(further), {false, false, true});
  const double out = bounds[0] - stage.probe->GetBounds()[0];
  EXPECT_NEAR(out, 0.31, stage.tolerance(left, further));
  EXPECT_NEAR(stage.probe->GetBounds()[1] - bounds[1], out, 1e-12);
  EXPECT_EQ(stage.probe->GetBounds()[5], bounds[5]);
}

TEST(ProbeWidget, EscapePutsTheProbeBackAndAClickEditsNothing) {
  Stage stage;
  stage.probe->SetOriginAtCenter(true);
  stage.start();
  std::ostringstream before;
  stage.probe->PrintSelf(before, vtkIndent());
  const vtkMTimeType time = stage.probe->GetMTime();
  const glm::dvec2 origin = stage.display(turnedPoint(stage.probe, {-0.1, -0.1, -0.15}));
  stage.press(origin, {});
  stage.send(vtkCommand::MouseMoveEvent, origin + glm::dvec2(1, 0), {});  // a hand is never quite still
  stage.send(vtkCommand::LeftButtonReleaseEvent, origin, {});
  EXPECT_EQ(stage.probe->GetMTime(), time);
  EXPECT_EQ(stage.counts.moved, 0);
  EXPECT_EQ(stage.counts.ended, 1);

  stage.press(origin, {});
  stage.lead(origin, origin + glm::dvec2(37, 21), {});
  EXPECT_FALSE(stage.probe->GetOriginAtCenter());
  EXPECT_NE(std::string(stage.shown()->GetReadout()), "");
  stage.interactor->SetKeyEventInformation(0, 0, 27, 0, "Escape");
  stage.interactor->InvokeEvent(vtkCommand::KeyPressEvent);
  std::ostringstream after;
  stage.probe->PrintSelf(after, vtkIndent());
  // The values; the times of modification in the superclass's lines went on.
  const auto values = [](const std::string& text) { return text.substr(text.find("Name:")); };
  EXPECT_EQ(values(after.str()), values(before.str()));
  EXPECT_EQ(stage.counts.ended, 2);
  EXPECT_STREQ(stage.shown()->GetReadout(), "");
  // The button comes up later, over nothing that is held.
  stage.send(vtkCommand::MouseMoveEvent, origin + glm::dvec2(50, 30), {});
  stage.send(vtkCommand::LeftButtonReleaseEvent, origin + glm::dvec2(50, 30), {});
  EXPECT_EQ(stage.counts.ended, 2);
}

TEST(ProbeWidget, BesideTheHandlesEventsReachOthers) {
  Stage stage;
  stage.start();
  int presses = 0;
  vtkNew<vtkCallbackCommand> style;
  style->SetClientData(&presses);
  style->SetCallback([](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
  stage.interactor->AddObserver(vtkCommand::LeftButtonPressEvent, style, 0.0F);
  stage.drag({60, 440}, {90, 400});
  EXPECT_EQ(presses, 1);
  EXPECT_EQ(stage.counts.started, 0);
  const glm::dvec2 face = stage.display(faceCenter(stage.probe, stage.probe->GetBounds(), 1));
  stage.drag(face, face + glm::dvec2(12, 5));
  EXPECT_EQ(presses, 1) << "the widget keeps what is its own";
}

TEST(ProbeWidget, ReadoutsTellTheValuesWithTheirUnit) {
  Stage stage;
  stage.start();
  stage.shown()->SetLengthUnit("mm");
  const glm::dvec3 from = faceCenter(stage.probe, stage.probe->GetBounds(), 1);
  const glm::dvec2 to = stage.display(from + 0.2 * faceNormal(stage.probe, 1));
  stage.press(stage.display(from), {});
  const ImageRgba8 before = stage.picture();
  stage.lead(stage.display(from), to, {});
  const std::string text = stage.shown()->GetReadout();
  char value[64];
  std::snprintf(value, sizeof(value), "+X  %.3f mm\n", stage.probe->GetBounds()[1]);
  EXPECT_EQ(text.find(value), 0u) << text;
  EXPECT_NE(text.find("size "), std::string::npos) << text;
  const ImageRgba8 with = stage.picture();
  keepPicture(with, "probe_widget_readout");
  stage.shown()->ReadoutVisibilityOff();
  EXPECT_GT(meanDifference(with, stage.picture()), 0.2) << "drawn beside the pointer";
  stage.send(vtkCommand::LeftButtonReleaseEvent, to, {});
  EXPECT_STREQ(stage.shown()->GetReadout(), "");
}

TEST(ProbeWidget, CapturesAndPicturesWithoutItAreAsIfItWereNotThere) {
  Stage without, with;
  const ImageRgba8 plain = without.picture();
  with.start();
  EXPECT_GT(meanDifference(plain, with.picture()), 0.3);
  keepPicture(with.picture(), "probe_widget_box");
  EXPECT_EQ(with.bare().pixels, plain.pixels);
  with.widget->SetProbe(nullptr);
  EXPECT_EQ(with.picture().pixels, plain.pixels) << "no probe: nothing is drawn";
  with.widget->SetProbe(with.probe);
  EXPECT_GT(meanDifference(plain, with.picture()), 0.3);
  const int renderers = with.window->GetRenderers()->GetNumberOfItems();
  with.widget->Off();
  EXPECT_EQ(with.window->GetRenderers()->GetNumberOfItems(), renderers - 2);
  EXPECT_EQ(with.picture().pixels, plain.pixels);
  EXPECT_EQ(with.captures.captures, 1);
  vtkNew<vtkPropCollection> drawn;
  with.start();
  with.shown()->GetActors(drawn);
  EXPECT_EQ(drawn->GetNumberOfItems(), 0);
}

/// Columns about a point on its own row in which two pictures differ, without a gap.
int widthOfChange(const ImageRgba8& a, const ImageRgba8& b, const glm::dvec2& display) {
  const int y = a.height - 1 - static_cast<int>(std::floor(display.y)), middle = static_cast<int>(display.x);
  int first = middle, last = middle;
  while (first > 0 && at(a, first - 1, y) != at(b, first - 1, y)) --first;
  while (last + 1 < a.width && at(a, last + 1, y) != at(b, last + 1, y)) ++last;
  return at(a, middle, y) != at(b, middle, y) ? last - first + 1 : 0;
}

TEST(ProbeWidget, HandlesHaveTheirSizeOnTheScreenWhateverTheirDistanceAndTheDpi) {
  Stage stage;
  stage.probe->SetOrientation(0, 0, 0);
  stage.probe->SetBounds(-2.1, 1.9, -1.7, 1.6, -6.4, 2.1);
  stage.probe->SetOrigin(1.5, 1.2, 0.3);
  stage.renderer->GetActiveCamera()->SetPosition(0.65, 0.1, 8.0);  // both in the clear, between the edges
  stage.renderer->GetActiveCamera()->SetFocalPoint(0.65, 0.1, 0.0);
  stage.start();
  const glm::dvec3 near = faceCenter(stage.probe, stage.probe->GetBounds(), 5),
                   far = faceCenter(stage.probe, stage.probe->GetBounds(), 4);
  ASSERT_GT(stage.unitsPerPixel(far) / stage.unitsPerPixel(near), 2.0);
  const auto widths = [&](double scale) {
    const ImageRgba8 bare = stage.bare(), drawn = stage.picture();
    keepPicture(drawn, "probe_widget_size_" + std::to_string(static_cast<int>(scale * 10)));
    return std::array<int, 2>{widthOfChange(bare, drawn, stage.display(near)),
                              widthOfChange(bare, drawn, stage.display(far))};
  };
  // A ball of 14 pixels with a rim of 2, at the minimum 3, on both sides.
  EXPECT_NEAR(widths(1.0)[0], 18, 1);
  EXPECT_NEAR(widths(1.0)[1], 20, 1);
  stage.window->SetDPI(144);
  EXPECT_NEAR(widths(2.0)[0], 36, 1);
  EXPECT_NEAR(widths(2.0)[1], 40, 1);
  stage.window->SetDPI(72);
  stage.shown()->SetHandleSize(9);
  EXPECT_NEAR(widths(0.9)[0], 13, 1);
  EXPECT_NEAR(widths(0.9)[1], 15, 1);
}

TEST(ProbeWidget, ColoursArePropertiesAndTheOneUnderThePointerIsBrighter) {
  Stage stage;
  stage.start();
  const glm::dvec2 face = stage.display(faceCenter(stage.probe, stage.probe->GetBounds(), 1));
  const auto color = [&] { return at(stage.picture(), static_cast<int>(face.x), 479 - static_cast<int>(face.y)); };
  stage.shown()->SetXAxisColor(0.1, 0.6, 0.2);
  const auto green = color();
  EXPECT_GT(green[1], green[0] + 60);
  EXPECT_GT(green[1], green[2] + 60);
  stage.send(vtkCommand::MouseMoveEvent, face, {});
  EXPECT_GT(color()[1], green[1] + 20);
  stage.send(vtkCommand::MouseMoveEvent, {60, 440}, {});
  EXPECT_EQ(color(), green);
}

TEST(ProbeWidget, TwoRenderersHaveTheirOwn) {
  Stage stage;
  stage.renderer->SetViewport(0.0, 0.0, 0.45, 1.0);
  vtkNew<vtkRenderer> second;
  second->SetViewport(0.45, 0.0, 1.0, 0.9);
  for (const auto& wall : stage.others) second->AddActor(wall);
  second->GetActiveCamera()->DeepCopy(stage.renderer->GetActiveCamera());
  second->GetActiveCamera()->SetPosition(-2.4, 2.0, 6.1);
  stage.window->AddRenderer(second);
  vtkNew<vtkReflectionProbe> other;
  other->SetBounds(-1.0, 0.7, -0.9, 0.4, -1.1, 1.2);
  vtkNew<vtkReflectionProbeWidget> widget;
  widget->SetInteractor(stage.interactor);
  widget->SetProbe(other);
  widget->SetDefaultRenderer(second);
  stage.widget->SetDefaultRenderer(stage.renderer);
  stage.widget->On();
  stage.window->Render();
  const ImageRgba8 one = stage.picture();
  widget->On();
  EXPECT_EQ(widget->GetCurrentRenderer(), second.Get());
  const ImageRgba8 both = stage.picture();
  keepPicture(both, "probe_widget_two");
  int left = 0, right = 0;
  for (int y = 0; y < one.height; ++y) {
    for (int x = 0; x < one.width; ++x) (x < 288 ? left : right) += at(one, x, y) != at(both, x, y) ? 1 : 0;
  }
  EXPECT_EQ(left, 0);
  EXPECT_GT(right, 500);

  Counts theirs(widget);
  const glm::dvec3 from = faceCenter(other, other->GetBounds(), 1), to = from + glm::dvec3(0.4, 0, 0);
  const std::array<double, 6> bounds = {-1.3, 1.1, -0.8, 0.6, -1.2, 0.9};
  const glm::dvec2 a = stage.display(from, second), b = stage.display(to, second);
  stage.drag(a, b);
  EXPECT_EQ(theirs.ended, 1);
  EXPECT_EQ(stage.counts.started, 0);
  EXPECT_NEAR(other->GetBounds()[1], 1.1, 1.5 * 0.4 / glm::length(b - a));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(stage.probe->GetBounds()[i], bounds[i]);
  const glm::dvec3 own = faceCenter(stage.probe, stage.probe->GetBounds(), 5);
  stage.drag(stage.display(own), stage.display(own + 0.3 * faceNormal(stage.probe, 5)));
  EXPECT_EQ(theirs.started, 1);
  EXPECT_GT(stage.probe->GetBounds()[5], 1.1);
  widget->Off();
  stage.window->RemoveRenderer(second);
}

TEST(ProbeWidget, TwoProbesOfOneRendererAreDraggedApart) {
  Stage stage;
  vtkNew<vtkReflectionProbe> other;
  other->SetBounds(-1.8, -1.5, 0.3, 0.7, -0.4, 0.2);
  vtkNew<vtkReflectionProbeWidget> widget;
  widget->SetInteractor(stage.interactor);
  widget->SetDefaultRenderer(stage.renderer);
  widget->SetProbe(other);
  widget->On();
  stage.start();
  const glm::dvec3 from = faceCenter(other, other->GetBounds(), 3), to = from + glm::dvec3(0, 0.25, 0);
  stage.drag(stage.display(from), stage.display(to));
  EXPECT_NEAR(other->GetBounds()[3], 0.95, stage.tolerance(from, to));
  EXPECT_EQ(stage.counts.started, 0);
  const glm::dvec3 own = faceCenter(stage.probe, stage.probe->GetBounds(), 3);
  const glm::dvec3 higher = own + 0.2 * faceNormal(stage.probe, 3);
  const double top = other->GetBounds()[3];
  stage.drag(stage.display(own), stage.display(higher));
  EXPECT_NEAR(stage.probe->GetBounds()[3] - 0.6, 0.2, stage.tolerance(own, higher) + 1e-9);
  EXPECT_EQ(other->GetBounds()[3], top);
  // The handles of both are there.
  stage.widget->Off();
  const ImageRgba8 one = stage.picture();
  widget->Off();
  EXPECT_GT(meanDifference(one, stage.picture()), 0.02);
}

TEST(ProbeWidget, AnotherModeEndsADragAndPutsTheProbeBack) {
  Stage stage;
  stage.start();
  const glm::dvec2 face = stage.display(faceCenter(stage.probe, stage.probe->GetBounds(), 5));
  stage.press(face, {});
  stage.lead(face, face + glm::dvec2(-20, -16), {});
  EXPECT_GT(stage.probe->GetBounds()[5], 0.95);
  stage.shown()->SetModeToOrigin();
  EXPECT_EQ(stage.probe->GetBounds()[5], 0.9);
  stage.lead(face, face + glm::dvec2(-20, -16), {});
  EXPECT_EQ(stage.probe->GetBounds()[5], 0.9);
  EXPECT_EQ(stage.counts.ended, 1);
}

TEST(ProbeWidget, AProbeTakenAwayEndsItsDrag) {
  Stage stage;
  stage.start();
  const glm::dvec2 face = stage.display(faceCenter(stage.probe, stage.probe->GetBounds(), 1));
  stage.press(face, {});
  stage.lead(face, face + glm::dvec2(20, 3), {});
  const double at = stage.probe->GetBounds()[1];
  EXPECT_GT(at, 1.15);
  stage.shown()->SetProbe(nullptr);
  stage.lead(face + glm::dvec2(20, 3), face + glm::dvec2(60, 9), {});
  EXPECT_EQ(stage.probe->GetBounds()[1], at);
  EXPECT_EQ(stage.counts.ended, 1);
  stage.send(vtkCommand::LeftButtonReleaseEvent, face, {});
  EXPECT_EQ(stage.counts.ended, 1);

  // From the renderer's probes: the drag goes on, and lights nothing.
  stage.widget->SetProbe(stage.probe);
  const glm::dvec3 from = faceCenter(stage.probe, stage.probe->GetBounds(), 1);
  stage.press(stage.display(from), {});
  stage.lead(stage.display(from), stage.display(from) + glm::dvec2(10, 2), {});
  stage.probes->RemoveProbe(stage.probe);
  stage.lead(stage.display(from) + glm::dvec2(10, 2), stage.display(from) + glm::dvec2(30, 5), {});
  stage.send(vtkCommand::LeftButtonReleaseEvent, stage.display(from), {});
  EXPECT_GT(stage.probe->GetBounds()[1], at + 0.05);
  EXPECT_EQ(stage.captures.errors, 0);

  // Switched off, and deleted, in the midst of a drag.
  const glm::dvec3 again = faceCenter(stage.probe, stage.probe->GetBounds(), 1);
  stage.press(stage.display(again), {});
  stage.widget->Off();
  EXPECT_EQ(stage.counts.ended, 3);
  const int renderers = stage.window->GetRenderers()->GetNumberOfItems();
  vtkSmartPointer<Shown> kept;
  {
    vtkNew<vtkReflectionProbeWidget> brief;
    brief->SetInteractor(stage.interactor);
    brief->SetProbe(stage.probe);
    brief->On();
    stage.window->Render();
    stage.press(stage.display(again), {});
    kept = brief->GetReflectionProbeRepresentation();
    EXPECT_TRUE(kept->GetDragging());
    EXPECT_EQ(stage.window->GetRenderers()->GetNumberOfItems(), renderers + 2);
  }
  EXPECT_FALSE(kept->GetDragging());
  EXPECT_EQ(stage.window->GetRenderers()->GetNumberOfItems(), renderers);
  const double rests = stage.probe->GetBounds()[1];
  stage.lead(stage.display(again), stage.display(again) + glm::dvec2(50, 8), {});
  EXPECT_EQ(stage.probe->GetBounds()[1], rests);
}

TEST(ProbeWidget, NullsAndWhatIsNotThereYetAreNoTrouble) {
  vtkNew<vtkReflectionProbeRepresentation> shown;
  vtkNew<vtkReflectionProbe> probe;
  double place[2] = {3, 4};
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(shown->ComputeInteractionState(3, 4), Shown::Outside);
    shown->StartWidgetInteraction(place);
    shown->WidgetInteraction(place);
    shown->EndWidgetInteraction(place);
    shown->CancelInteraction();
    shown->Highlight(1);
    shown->BuildRepresentation();
    EXPECT_FALSE(shown->GetDragging());
    EXPECT_EQ(shown->GetInteractionFace(), -1);
    EXPECT_EQ(shown->GetBounds() != nullptr, round == 1);
    shown->SetProbe(probe);
  }
  double box[6] = {-1, 3, 0, 2, -5, 4};
  shown->SetPlaceFactor(1.0);
  shown->PlaceWidget(box);
  EXPECT_EQ(probe->GetBounds()[4], -5.0);
  // A renderer without a window.
  vtkNew<vtkRenderer> renderer;
  shown->SetRenderer(renderer);
  shown->BuildRepresentation();
  shown->ComputeInteractionState(3, 4);
  EXPECT_NEAR(shown->GetBounds()[3], 2.0, 1e-12);
  shown->SetRenderer(nullptr);

  // A widget without an interactor, and with one that has no window: one line each.
  vtkNew<vtkReflectionProbeWidget> widget;
  Counts counts(widget);
  EXPECT_EQ(widget->GetProbe(), nullptr);
  widget->On();
  EXPECT_EQ(widget->GetEnabled(), 0);
  EXPECT_EQ(counts.errors, 1);
  vtkNew<vtkRenderWindowInteractor> interactor;
  widget->SetInteractor(interactor);
  widget->On();
  EXPECT_EQ(widget->GetEnabled(), 0);
  EXPECT_EQ(counts.errors, 2);
  widget->Off();
}

TEST(ProbeWidget, RoomsOfAMillimetreAreDraggedAsOthers) {
  Stage stage;
  constexpr double kSmall = 0.001;
  stage.probe->SetOrientation(0, 0, 0);
  stage.probe->SetBounds(-1.3 * kSmall, 1.1 * kSmall, -0.8 * kSmall, 0.6 * kSmall, -1.2 * kSmall, 0.9 * kSmall);
  stage.probe->SetOrigin(0, 0, 0);
  vtkCamera* camera = stage.renderer->GetActiveCamera();
  camera->SetPosition(2.9 * kSmall, 2.3 * kSmall, 5.6 * kSmall);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetClippingRange(0.05 * kSmall, 40 * kSmall);
  stage.start();
  const glm::dvec3 from = faceCenter(stage.probe, stage.probe->GetBounds(), 1);
  const glm::dvec3 to = from - glm::dvec3(0.6 * kSmall, 0, 0);
  stage.drag(stage.display(from), stage.display(to));
  EXPECT_NEAR(stage.probe->GetBounds()[1], 0.5 * kSmall, stage.tolerance(from, to));
  EXPECT_EQ(stage.probe->GetBounds()[0], -1.3 * kSmall);
}

TEST(ProbeWidget, TellsItsStateAndFollowsTheProbesTime) {
  vtkNew<vtkReflectionProbeWidget> widget;
  vtkNew<vtkReflectionProbe> probe;
  widget->SetProbe(probe);
  Shown* shown = widget->GetReflectionProbeRepresentation();
  const vtkMTimeType before = shown->GetMTime();
  probe->SetBounds(-1, 2, -3, 4, -5, 6);
  EXPECT_GT(shown->GetMTime(), before);
  shown->SetMode(77);
  EXPECT_EQ(shown->GetMode(), Shown::PLACE);
  shown->SetAngleStep(7.5);
  shown->SetLengthUnit("km");
  std::ostringstream text;
  widget->Print(text);
  shown->Print(text);
  for (const char* part :
       {"ModifierKeys: 1", "Mode: 3", "AngleStep: 7.5", "LengthUnit: km", "SnapDistance: 14", "BoxColor: 1 0.70"}) {
    EXPECT_NE(text.str().find(part), std::string::npos) << part << " in\n" << text.str();
  }
  EXPECT_STREQ(shown->GetClassName(), "vtkReflectionProbeRepresentation");
  EXPECT_TRUE(widget->IsA("vtkAbstractWidget"));
}

TEST(ProbeWidget, TheExampleDrawsItsHandles) {
  const std::string file = testing::TempDir() + "probe_widget.png";
  ASSERT_EQ(std::system((std::string(BOXPROBE_WIDGET_EXAMPLE) + " " + file).c_str()), 0);
  const ImageRgba8 picture = loadImage8(file);
  keepPicture(picture, "probe_widget_example");
  int balls = 0;  // in the colour of +Y, which no wall has
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const auto c = at(picture, x, y);
      balls += c[1] > c[0] + 30 && c[1] > c[2] + 60 ? 1 : 0;
    }
  }
  EXPECT_GT(balls, 60);
}

}  // namespace
