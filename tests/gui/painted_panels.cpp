// See painted_panels.h.
#include "tests/gui/painted_panels.h"

#include <QFont>
#include <QIcon>
#include <QPainter>
#include <functional>

#include "app/gui/explain/footprint_view.h"
#include "app/gui/explain/schematic_painter.h"
#include "app/gui/formula/formula_label.h"
#include "app/gui/formula/formula_picture.h"
#include "app/gui/lessons/curve_picture.h"
#include "app/gui/lessons/lesson_list_page.h"
#include "app/gui/lessons/lesson_progress.h"
#include "app/gui/lessons/lesson_sheet.h"
#include "app/gui/lessons/lesson_step_page.h"
#include "app/gui/panels/outliner_model.h"
#include "app/gui/panels/placed_list.h"
#include "app/gui/widgets/quiet_combo.h"
#include "app/gui/widgets/scene_card.h"
#include "app/gui/widgets/text_button.h"
#include "app/gui/widgets/tool_icons.h"
#include "app/gui/widgets/vector_row.h"
#include "tests/gui/some_lesson.h"
#include "tests/unit/explained_room.h"
#include "tests/unit/two_probes.h"

namespace boxprobe {

namespace {

/// Each kind of row, with what is hidden and locked.
void addOutlinerMarks(std::map<std::string, QImage>& pictures) {
  ViewState state;
  OutlinerModel model(state);
  auto loaded = std::make_shared<Model>();
  loaded->materials.resize(2);
  loaded->materials[1].name = "glow";
  loaded->materials[1].emissive = {0.1f, 0.2f, 0.6f};
  loaded->meshes.resize(2);
  loaded->meshes[1].material = 1;
  for (const char* name : {"desk", "bulb"}) {
    Instance instance;
    instance.node = name;
    instance.mesh = name[0] == 'b' ? 1 : 0;
    loaded->instances.push_back(instance);
  }
  loaded->meshes[0].material = 0;
  model.setModels({loaded});
  Scene scene = twoProbes();
  scene.lights.resize(1);
  scene.cameras.resize(1);
  scene.cameras[0].name = "view";
  model.show(scene, {});
  state.setHidden(ViewState::Part::Object, {"bulb"}, true);
  state.setLocked(ViewState::Part::Object, {"desk"}, true);
  const auto add = [&pictures](const std::string& name, const QVariant& icon) {
    for (const auto mode : {QIcon::Normal, QIcon::Selected}) {
      const QPixmap mark = icon.value<QIcon>().pixmap(QSize(16, 16), mode);
      pictures["mark " + name + (mode == QIcon::Normal ? "" : " selected")] =
          painted(48, 48, [&](QPainter& p) { p.drawPixmap(QRect(0, 0, 48, 48), mark); });
    }
  };
  const QModelIndex desk = model.object("desk"), bulb = model.object("bulb");
  add("object", model.data(desk, Qt::DecorationRole));
  add("lamp", model.data(bulb, Qt::DecorationRole));
  add("eye", model.data(desk.siblingAtColumn(OutlinerModel::kEye), Qt::DecorationRole));
  add("eye shut", model.data(bulb.siblingAtColumn(OutlinerModel::kEye), Qt::DecorationRole));
  add("lock", model.data(desk.siblingAtColumn(OutlinerModel::kLock), Qt::DecorationRole));
  add("lock open", model.data(bulb.siblingAtColumn(OutlinerModel::kLock), Qt::DecorationRole));
  for (const auto kind : {OutlinerModel::Kind::Lights, OutlinerModel::Kind::Cameras}) {
    add(kind == OutlinerModel::Kind::Lights ? "light" : "camera",
        model.data(model.index(0, 0, model.group(kind)), Qt::DecorationRole));
  }
}

void addSmallWidgets(std::map<std::string, QImage>& pictures) {
  const std::pair<const char*, ToolIcon> icons[] = {{"box", ToolIcon::Box},
                                                    {"influence", ToolIcon::Influence},
                                                    {"origin", ToolIcon::Origin},
                                                    {"place", ToolIcon::Place}};
  for (const auto& [name, icon] : icons) {
    const QPixmap grey = toolIcon(icon).pixmap(QSize(36, 48), QIcon::Disabled);
    pictures[std::string("icon grey ") + name] = painted(36, 48, [&](QPainter& p) { p.drawPixmap(0, 0, grey); });
  }
  TextButton answer;
  answer.show("", "An answer of more words than there is room for in one line of it", "");
  for (const auto mark : {TextButton::Mark::Empty, TextButton::Mark::Right, TextButton::Mark::Wrong}) {
    answer.setMark(mark);
    pictures["answer " + std::to_string(static_cast<int>(mark))] = grabbed(answer, 190, answer.heightForWidth(190));
  }
  answer.setDown(true);
  pictures["answer down"] = grabbed(answer, 190, answer.heightForWidth(190));
  answer.setDown(false);
  answer.setEnabled(false);
  pictures["answer grey"] = grabbed(answer, 190, answer.heightForWidth(190));
  SceneCard tall("A title that is far too long for the width of its card", "and words that are longer still than that");
  tall.setPicture(someColors(70, 160));
  tall.setDown(true);
  pictures["card tall down"] = grabbed(tall, tall.sizeHint().width(), tall.sizeHint().height());
  QuietCombo combo;
  combo.addItem("chosen");
  combo.setDiffers(true);
  pictures["choice that differs"] = grabbed(combo, 140, 28);
  VectorRow row({-10.0, 10.0, 0.1, 3, " m"}, "a place", nullptr, "XYZ");
  row.show({1.25, -2.5, 3.75});
  row.field(1)->setDiffers(true);
  row.field(2)->setEnabled(false);
  pictures["three numbers"] = grabbed(row, 330, 28);
  FormulaLabel formula;
  formula.setMathml(
      "<math><mi>t</mi><mo>=</mo><mfrac><mrow><mi>b</mi><mo>-</mo><mi>p</mi></mrow><mi>r</mi></mfrac></math>",
      "t = (b - p) / r");
  for (const int width : {60, 150, 320}) {
    pictures["formula " + std::to_string(width)] = grabbed(formula, width, formula.heightForWidth(width));
  }
  const QString root = "<math><msqrt><mi>x</mi><mo>+</mo><mn>1</mn></msqrt></math>";
  for (const double scale : {1.0, 2.5}) {
    const QImage picture = formulaPicture(root, 17.0, QColor(200, 220, 90), scale);
    pictures["formula picture " + std::to_string(scale)] =
        painted(picture.width() + 3, picture.height() + 4, [&](QPainter& p) {
          QImage plain = picture;
          plain.setDevicePixelRatio(1.0);
          p.drawImage(1, 2, plain);
        });
  }
}

void addOddDrawings(std::map<std::string, QImage>& pictures) {
  ExplainedRoom outside, flat, endOn, farAway, seen;
  outside.probe.origin = {0.3, 40.0, 0.2};
  flat.probe.box.max.y = flat.probe.box.min.y;
  endOn.surface.eyeWorld = endOn.surface.positionWorld + glm::dvec3(0.0, 2.0, 0.0);
  endOn.surface.viewWorld = {0.0f, 1.0f, 0.0f};
  farAway.surface.eyeWorld = {1e5, 1e5, 1e5};
  farAway.surface.viewWorld = glm::normalize(glm::vec3(1.0f));
  seen.surface.positionWorld = {-0.63, 0.0, 1.21};
  seen.surface.eyeWorld = {1.31, 1.47, -1.13};
  seen.surface.viewWorld = glm::normalize(glm::vec3(seen.surface.eyeWorld - seen.surface.positionWorld));
  seen.probe.rotationDegrees = {0.0, -33.0, 0.0};
  Explanation truth = seen.explain();
  truth.probes[0].trueDistance = 0.6f * truth.probes[0].hitDistance.value_or(1.0f);
  const std::pair<const char*, Explanation> drawn[] = {{"outside", outside.explain()},
                                                       {"flat", flat.explain()},
                                                       {"end on", endOn.explain()},
                                                       {"far away", farAway.explain()},
                                                       {"with the truth", truth}};
  for (const auto& [name, explanation] : drawn) {
    const auto drawing = schematic(explanation);
    if (!drawing) continue;
    pictures[std::string("schematic ") + name] =
        painted(380, 240, [&](QPainter& p) { paintSchematic(p, QRectF(5, 3, 370, 231), *drawing); });
    for (const bool elevation : {false, true}) {
      const auto view = insetView(explanation, elevation);
      if (!view) continue;
      pictures[std::string("inset ") + name + (elevation ? " from the side" : "")] =
          painted(190, 150, [&](QPainter& p) {
            const QSizeF size = insetSize(p, *view, {190, 150});
            paintInset(p, QRectF(QPointF(2, 1), size), *view, "words");
          });
    }
  }
}

/// Texels smaller than a pixel, many lookups, none.
void addFootprints(std::map<std::string, QImage>& pictures) {
  const auto cube = [](int size, int levels) {
    auto maps = std::make_shared<BakedMaps>();
    maps->radiance = CubeMap(size, levels);
    for (int level = 0; level < levels; ++level) {
      const int side = maps->radiance.levelSize(level);
      for (int face = 0; face < 6; ++face) {
        for (int i = 0; i < side * side; ++i) {
          const float s = static_cast<float>(i % side) / static_cast<float>(side),
                      t = static_cast<float>(i / side) / static_cast<float>(side);
          maps->radiance.setTexel(level, face, i % side, i / side,
                                  {0.05f + 0.15f * static_cast<float>(face) * s, 0.9f * t * t, 0.3f * s + 0.2f, 1.0f});
        }
      }
    }
    return maps;
  };
  const std::shared_ptr<BakedMaps> fine = cube(256, 9), coarse = cube(8, 4);
  const auto add = [&](const char* name, const std::shared_ptr<BakedMaps>& maps, const char* technique, float roughness,
                       int width, int height, double exposure) {
    ExplainedRoom room;
    room.probe.name = "the hall";
    room.probe.technique = technique;
    room.surface.roughness = roughness;
    room.surface.positionWorld = {0.83, 0.0, -1.37};
    room.maps = *maps;
    const Explanation e = room.explain();
    FootprintView view;
    view.show(e.probes.front(), maps, exposure);
    pictures[std::string("footprint ") + name] = grabbed(view, width, height);
  };
  add("of a mirror", fine, "box", 0.02f, 320, 240, 1.0);
  add("of many lookups", coarse, "box+raytraced", 0.7f, 300, 300, 0.7);
  add("of a few", coarse, "box+footprint4", 0.45f, 420, 230, 1.6);
  add("far up", fine, "box", 0.9f, 260, 220, 1.1);
  add("at another edge", cube(16, 5), "infinite", 0.3f, 288, 216, 1.0);
  FootprintView view;
  ProbeExplanation none;
  none.name = "empty";
  view.show(none, coarse, 1.0);
  pictures["footprint of nothing"] = grabbed(view, 288, 216);
}

void addPagePictures(std::map<std::string, QImage>& pictures) {
  const Lesson lesson = someLesson();
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    LessonStepPage page;
    page.show(lesson, i, {i == 2, i == 2});
    page.showTry(i != 1, i > 0);
    pictures["step " + std::to_string(i)] = grabbed(page, 330, 560);
  }
  LessonList list;
  list.lessons = {lesson, lesson, lesson};
  list.lessons[1].name = "second";
  list.lessons[1].chapter = "Other things";
  list.lessons[2].name = "third";
  list.lessons[2].chapter = "Other things";
  list.errors = {"4-broken.lesson.json: line 3: there is no scene"};
  forgetLessons();
  keepLessonProgress("second", {1, false, {}});
  keepLessonProgress("third", {3, true, {}});
  for (const char* last : {"", "second"}) {
    LessonListPage page;
    page.setLessonOpen(*last != '\0');
    page.show(list);
    page.showProgress(list, last);
    pictures[std::string("list ") + (*last != '\0' ? "with one to go on" : "of lessons")] = grabbed(page, 310, 620);
  }
  forgetLessons();

  LessonPictures taken;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) taken.steps.push_back(someColors(220, 130));
  pictures["sheet"] = lessonSheet(lesson, taken);
  Lesson one = lesson;
  one.unreviewed = "nobody has read it";
  one.steps.resize(1);
  one.steps[0].formula = "R = 2 (N \\cdot V) N - V \\quad H = P + d R \\quad d = \\min(t_x, t_y, t_z)";
  taken.steps.resize(1);
  pictures["sheet of one"] = lessonSheet(one, taken);

  LessonCurve curve;
  curve.values = {0.5, 1, 3};
  curve.fieldName = "roughness";
  curve.measureName = "light";
  pictures["curve of large values"] = curvePicture(curve, {{410, 1730, 960}, {}, {}}, 400, 250);
  pictures["curve of nothing"] = curvePicture(curve, {{0, 0, 0}, {}, {}}, 400, 250);
  curve.line.emplace();
  curve.lineName = "as it should be";
  pictures["curve below its line"] = curvePicture(curve, {{0.0021, 0.0007, 0.0013}, {}, 0.0047}, 330, 300);
}

void addPlacedPictures(std::map<std::string, QImage>& pictures) {
  PlacedEntry plain, pictured;
  plain.name = "hall";
  plain.reason = "As it is, but with 2 bounces of light";
  pictured.name = "kitchen";
  pictured.reason = "One for the room";
  pictured.gain = "Error of kitchen 0.2 to 0.1";
  pictured.details = "3.0 x 2.0 x 4.0";
  for (int i = 0; i < PlacedPictures::kCount; ++i) {
    pictured.pictures.images[static_cast<std::size_t>(i)] = someColors(90 + 8 * i, 60);
  }
  PlacedList list;
  list.show({plain, pictured});
  pictures["placed"] = grabbed(list, 330, 190);
  PlacedPicturesDialog dialog(pictured, nullptr);
  pictures["placed pictures"] = grabbed(dialog, 1360, 700);
}

}  // namespace

QImage painted(int width, int height, const std::function<void(QPainter&)>& paint) {
  QImage image(width, height, QImage::Format_RGB32);
  image.fill(QColor(37, 41, 52));
  QPainter painter(&image);
  painter.setFont(QFont("DejaVu Sans", 9));
  paint(painter);
  return image;
}

QImage grabbed(QWidget& widget, int width, int height) {
  widget.resize(width, height);
  widget.ensurePolished();
  return widget.grab().toImage();
}

QImage someColors(int width, int height) {
  QImage image(width, height, QImage::Format_RGB32);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x)
      image.setPixel(x, y, qRgb(220 * x / width, 190 * y / height, 60 + (x + 2 * y) % 70));
  }
  return image;
}

void addPaintedPanels(std::map<std::string, QImage>& pictures) {
  addOutlinerMarks(pictures);
  addSmallWidgets(pictures);
  addOddDrawings(pictures);
  addFootprints(pictures);
  addPagePictures(pictures);
  addPlacedPictures(pictures);
}

}  // namespace boxprobe
