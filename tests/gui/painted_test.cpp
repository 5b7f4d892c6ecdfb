// What the window paints itself, against painted.txt: icons, marks, drawings of rays, curves, lesson sheets.
#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkNew.h>

#include <QIcon>
#include <QImage>
#include <QPainter>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/gui/explain/footprint_view.h"
#include "app/gui/explain/picture_inset.h"
#include "app/gui/explain/schematic_inset.h"
#include "app/gui/explain/schematic_painter.h"
#include "app/gui/lessons/curve_picture.h"
#include "app/gui/lessons/lesson_pictures.h"
#include "app/gui/lessons/lesson_sheet.h"
#include "app/gui/lessons/ray_letters.h"
#include "app/gui/panels/bake_state_look.h"
#include "app/gui/view/compare_views.h"
#include "app/gui/view/compare_wipe.h"
#include "app/gui/widgets/cube_view.h"
#include "app/gui/widgets/scene_card.h"
#include "app/gui/widgets/symbol_text.h"
#include "app/gui/widgets/text_button.h"
#include "app/gui/widgets/tool_icons.h"
#include "filters/vtk/widgets/view_projection.h"
#include "tests/gui/kept_pictures.h"
#include "tests/gui/painted_panels.h"
#include "tests/unit/explained_room.h"

namespace boxprobe {
namespace {

// Of 255: what a machine may round otherwise.
constexpr int kSame = 3;

QImage sheet(int width, int height) {
  QImage image(width, height, QImage::Format_RGB32);
  image.fill(QColor(37, 41, 52));
  return image;
}

/// No two texels of a face are alike, and no two faces.
CubeMap someCube() {
  CubeMap cube(8, 4);
  for (int level = 0; level < 4; ++level) {
    const int size = cube.levelSize(level);
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
          const float s = (static_cast<float>(column) + 0.5f) / static_cast<float>(size);
          const float t = (static_cast<float>(row) + 0.5f) / static_cast<float>(size);
          cube.setTexel(level, face, column, row,
                        {0.1f + 0.13f * static_cast<float>(face), 0.05f + 0.8f * s * s, 0.1f + 0.6f * t, 1.0f});
        }
      }
    }
  }
  return cube;
}

/// A turned box whose every number is another one.
ExplainedRoom oddRoom() {
  ExplainedRoom room;
  room.probe.origin = {0.31, 1.17, -0.42};
  room.probe.box = {{-1.9, 0.0, -3.1}, {2.3, 2.8, 2.6}};
  room.probe.rotationDegrees = {0.0, 17.0, 0.0};
  room.surface.positionWorld = {0.53, 0.0, 0.22};
  room.surface.eyeWorld = {-0.77, 1.21, -0.94};
  room.surface.viewWorld = glm::normalize(glm::vec3(room.surface.eyeWorld - room.surface.positionWorld));
  return room;
}

void addWidgets(std::map<std::string, QImage>& pictures) {
  const std::pair<const char*, ToolIcon> icons[] = {{"icon box", ToolIcon::Box},
                                                    {"icon influence", ToolIcon::Influence},
                                                    {"icon origin", ToolIcon::Origin},
                                                    {"icon place", ToolIcon::Place}};
  for (const auto& [name, icon] : icons) {
    pictures[name] = painted(64, 64, [icon = icon](QPainter& p) { toolIcon(icon).paint(&p, 0, 0, 64, 64); });
  }
  const std::pair<const char*, TextButton::Mark> marks[] = {{"button", TextButton::Mark::None},
                                                            {"button empty", TextButton::Mark::Empty},
                                                            {"button begun", TextButton::Mark::Begun},
                                                            {"button right", TextButton::Mark::Right},
                                                            {"button wrong", TextButton::Mark::Wrong}};
  for (const auto& [name, mark] : marks) {
    TextButton button;
    button.show("Three distances", "The ray leaves at the nearest of three planes, each of which is one division.",
                "7 min");
    button.setMark(mark);
    pictures[name] = grabbed(button, 240, button.heightForWidth(240));
    // The mark alone, large.
    button.setFont(QFont("DejaVu Sans", 60));
    button.show(" ", "");
    pictures[std::string(name) + " large"] = grabbed(button, 150, button.heightForWidth(150));
  }
  for (const bool filled : {false, true}) {
    const BakeStateLook look{"", QColor(108, 194, 90), filled};
    pictures[filled ? "state filled" : "state ring"] =
        painted(48, 48, [&](QPainter& p) { stateIcon(look).paint(&p, 0, 0, 48, 48); });
    SceneCard card("A hall", "of two doors and a lamp");
    if (filled) card.setPicture(someColors(160, 90));
    pictures[filled ? "card" : "card without"] = grabbed(card, card.sizeHint().width(), card.sizeHint().height());
  }
  int number = 0;
  for (const char* text : {"t_x = 2.12", "C", "ray 3", "R_12 and S"}) {
    pictures["symbol " + std::to_string(++number)] = painted(150, 40, [&](QPainter& p) {
      SymbolText(text, p.font()).paint(p, QRectF(11, 7, 120, 30), QColor(255, 166, 26), QColor(20, 24, 30));
    });
  }
  const CubeMap cube = someCube();
  for (const CubePictureKind kind : {CubePictureKind::Cross, CubePictureKind::LatLong}) {
    CubeFaces faces;
    faces.resize(256, faces.heightForWidth(256));
    faces.show(&cube, kind, 1.3f, "");
    pictures[kind == CubePictureKind::Cross ? "cube cross" : "cube lat-long"] =
        grabbed(faces, 256, faces.heightForWidth(256));
  }
  CubeFaces none;
  none.show(nullptr, CubePictureKind::Cross, 1.0f, "Not captured yet");
  pictures["cube none"] = grabbed(none, 256, 192);
}

void addComparisons(std::map<std::string, QImage>& pictures) {
  QWidget below;
  below.resize(480, 300);
  CompareWipe wipe(&below);
  wipe.show(someColors(480, 300), "Ray traced");
  wipe.setScaleShown(true);
  wipe.setDivider(0.37);
  wipe.showNumbers("RMSE 0.123");
  wipe.setShown(true);
  pictures["wipe"] = grabbed(below, 480, 300);
  wipe.setFlipped(true);
  pictures["wipe flipped"] = grabbed(below, 480, 300);
  wipe.setShown(false);

  QWidget other;
  other.resize(640, 420);
  CompareViews views(&other, {{"box", "Box", ""}, {"sphere", "Sphere", ""}, {"normal", "Without", ""}});
  views.choose(0, "box");
  views.choose(1, "sphere");
  for (int i = 0; i < 3; ++i) {
    views.show(i, someColors(320 - 40 * i, 180), "");
    views.showNumbers(i, i == 1 ? "error 0.123\nlight 0.98" : "error 0.456");
  }
  views.show(3, QImage(), "is traced");
  views.setShown(true);
  pictures["four views"] = grabbed(other, 640, 420);
  other.resize(960, 540);
  pictures["four views wide"] = grabbed(other, 960, 540);
}

void addDrawings(std::map<std::string, QImage>& pictures) {
  const ExplainedRoom room = oddRoom();
  const Explanation explained = room.explain();
  ExplainedRoom outside = room;
  outside.surface.eyeWorld = outside.surface.positionWorld + 9.0 * (room.surface.eyeWorld - room.surface.positionWorld);
  ExplainedRoom infinite = room;
  infinite.probe.technique = "infinite";
  for (const auto& [name, drawn] :
       {std::pair{"schematic", &room}, {"schematic outside", &outside}, {"schematic infinite", &infinite}}) {
    const auto drawing = schematic(drawn->explain());
    ASSERT_TRUE(drawing) << name;
    pictures[name] = painted(520, 260, [&](QPainter& p) { paintSchematic(p, QRectF(0, 0, 520, 260), *drawing); });
  }
  for (const bool elevation : {false, true}) {
    const auto view = insetView(explained, elevation);
    ASSERT_TRUE(view);
    const std::string name = elevation ? "from the side" : "from above";
    pictures["inset " + name] = painted(310, 230, [&](QPainter& p) {
      const QSizeF size = insetSize(p, *view, {310, 230});
      paintInset(p, QRectF(QPointF(0, 0), size), *view, QString::fromStdString(name));
    });
    LessonInset corner;
    corner.elevation = elevation;
    corner.right = elevation;
    corner.bottom = !elevation;
    pictures["picture inset " + name] =
        painted(480, 270, [&](QPainter& p) { paintPictureInset(p, QRectF(0, 0, 480, 270), corner, *view); });
  }
  pictures["letters"] = painted(96, 60, [](QPainter& p) {
    paintPictureLetter(p, {30, 34}, "R");
    paintInsetPlace(p, {70, 20});
  });
  {
    SchematicInset inset{SchematicInset::InLayout{}};
    inset.show(explained, {12.0, 17.0});
    pictures["schematic in a card"] = grabbed(inset, 360, 200);
  }
  {
    vtkNew<vtkCamera> camera;
    camera->SetPosition(-0.6, 2.1, 6.3);
    camera->SetFocalPoint(0.3, 0.9, 0.0);
    camera->SetViewUp(0.1, 1.0, 0.0);
    camera->SetViewAngle(47.0);
    QImage letters = sheet(480, 270);
    drawRayLetters(letters, explained, ViewProjection(camera, 480, 270));
    pictures["ray letters"] = letters;
  }
  const auto maps = std::make_shared<BakedMaps>();
  maps->radiance = someCube();
  ExplainedRoom captured = room;
  captured.maps = *maps;
  const Explanation lookup = captured.explain();
  ASSERT_FALSE(lookup.probes.empty());
  FootprintView footprint;
  footprint.show(lookup.probes.front(), maps, 1.3);
  pictures["footprint"] = grabbed(footprint, 384, 288);
  FootprintView notCaptured;
  notCaptured.show(lookup.probes.front(), nullptr, 1.0);
  pictures["footprint without"] = grabbed(notCaptured, 384, 288);
}

void addLessons(std::map<std::string, QImage>& pictures, std::string& svg) {
  LessonCurve curve;
  curve.values = {1, 2, 5, 16, 64};
  curve.fieldName = "rays";
  curve.measureName = "error";
  curve.costName = "samples";
  curve.lineName = "one lookup";
  curve.cost.emplace();
  curve.line.emplace();
  const CurvePoints points{{0.31, 0.22, 0.17, 0.09, 0.052}, {1, 2.2, 5.7, 17, 70}, 0.24};
  pictures["curve"] = curvePicture(curve, points, 480, 270);
  svg = curveSvg(curve, points, "Error by rays");
  LessonCurve plain = curve;
  plain.cost.reset();
  plain.line.reset();
  pictures["curve without cost"] = curvePicture(plain, {points.measured, {}, {}}, 480, 270);

  Lesson lesson;
  lesson.title = "Three distances";
  lesson.chapter = "Projection";
  lesson.summary = "A ray leaves a box at the nearest of three planes.";
  LessonPictures taken;
  for (int i = 0; i < 4; ++i) {
    LessonStep step;
    step.title = "Step of " + std::to_string(i + 3);
    step.say = "Each plane is one division, and the smallest distance is the way out.";
    if (i == 1) step.formula = "t_x = (b_x - p_x) / r_x";
    if (i == 2) step.mayMove = "a face";
    if (i == 3) step.question = LessonQuestion{"Which plane?", {{"x", true, ""}, {"the other", false, ""}}};
    lesson.steps.push_back(step);
    taken.steps.push_back(someColors(300, 160 + 2 * i));
  }
  LessonExercise exercise;
  exercise.ask = "Where does the ray leave?";
  lesson.exercises.push_back(exercise);
  taken.claims = {{"The error halves.", "0.21", true}, {"It is never zero.", "0.00", false}};
  pictures["sheet of four"] = lessonSheet(lesson, taken);
  lesson.steps.pop_back();
  taken.steps.pop_back();
  pictures["sheet of three"] = lessonSheet(lesson, taken);
}

TEST(Painted, IsAsBefore) {
  std::map<std::string, QImage> pictures;
  std::string svg;
  addWidgets(pictures);
  addComparisons(pictures);
  ASSERT_NO_FATAL_FAILURE(addDrawings(pictures));
  addLessons(pictures, svg);
  addPaintedPanels(pictures);
  for (char& c : svg) c = c == '\n' ? ' ' : c;
  expectKeptPictures("gui/values/painted.txt", pictures, {{"curve as svg", svg}}, kSame);
}

}  // namespace
}  // namespace boxprobe
