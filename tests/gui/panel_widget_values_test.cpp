// What parts of panels say and do without a window, against panel_widget_values.txt.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QToolButton>

#include "app/gui/explain/explain_card.h"
#include "app/gui/explain/explanation_html.h"
#include "app/gui/explain/footprint_view.h"
#include "app/gui/explain/ray_panel.h"
#include "app/gui/explain/surface_view_panel.h"
#include "app/gui/panels/bake_state_look.h"
#include "app/gui/panels/outliner_model.h"
#include "app/gui/panels/placed_list.h"
#include "app/gui/widgets/value_field.h"
#include "tests/gui/painted_panels.h"
#include "tests/gui/value_lines.h"
#include "tests/support/kept_values.h"
#include "tests/unit/explained_room.h"
#include "tests/unit/two_probes.h"

namespace boxprobe {
namespace {

void addExplain(ValueLines& lines) {
  ExplainedRoom room;
  room.probe.origin = {0.31, 1.17, -0.42};
  room.probe.rotationDegrees = {0.0, 17.0, 0.0};
  ExplainedRoom infinite = room, notCaptured = room, many = room;
  infinite.probe.technique = "infinite";
  notCaptured.captured = false;
  many.probe.technique = "box+footprint4";
  for (const auto& [name, each] :
       {std::pair{"box", &room}, {"infinite", &infinite}, {"not captured", &notCaptured}, {"many", &many}}) {
    const Explanation e = each->explain();
    ExplanationDetail detail;
    detail.texelValue = [each = each](const ProbeExplanation&, const TexelShare& t) -> std::optional<glm::vec3> {
      return glm::vec3(each->maps.radiance.texel(t.level, t.face, t.column, t.row));
    };
    QString html = explanationHtml(e, detail, 1.3, Tone::Agx);
    html.replace("<tr", "\n<tr");
    for (const QString& line : html.split('\n')) lines.add(std::string("html ") + name, line);
  }
  for (const char* symbol :
       {"t_x", "N.V", "E/pi", "H - C", "direct", "F_0", "direct light", "R", "P_<x>", "ab_c", "Rd"}) {
    lines.add(std::string("symbol ") + symbol, symbolHtml(Phrase::plain(symbol)));
  }
  for (const char* formula : {"min(t_x, t_y, t_z) - 1", "(-a) / -b ^2", "F_0 + (F_90 - F_0) alpha^2 < 1"}) {
    lines.add(std::string("formula ") + formula, formulaHtml(formula));
  }
  for (const Tone tone : {Tone::None, Tone::Agx}) {
    for (const float value : {-0.5f, 0.0f, 0.18f, 0.75f, 3.0f}) {
      lines.add("display", displayColor({value, 0.5f * value, 0.25f}, 1.5, tone).name());
    }
  }
  Explanation nothing;
  for (const SurfaceViewRow& row : surfaceViews()) {
    const std::string id(row.id);
    lines.add("readout " + id, surfaceViewReadout(row, room.explain()));
    lines.add("readout of nothing " + id, surfaceViewReadout(row, nothing));
  }

  RayPanel rays;
  QStringList told;
  const auto tell = [&told](const RaySettings& s) {
    QString kinds;
    for (const bool on : s.kinds) kinds += on ? '1' : '0';
    told += QString("%1 %2 '%3' %4 %5 %6 %7")
                .arg(s.shown)
                .arg(static_cast<int>(s.source))
                .arg(QString::fromStdString(s.object))
                .arg(s.count)
                .arg(s.maximumLength)
                .arg(kinds)
                .arg(static_cast<int>(s.coloring));
  };
  QObject::connect(&rays, &RayPanel::changed, tell);
  QObject::connect(&rays, &RayPanel::clearRequested, [&] { told += "clear"; });
  QObject::connect(&rays, &RayPanel::saveRequested, [&] { told += "save"; });
  rays.setObjects({"wall", "floor", "desk"});
  lines.tree("rays", rays);
  RaySettings settings;
  settings.shown = false;
  settings.source = RaySource::Object;
  settings.object = "floor";
  settings.count = 77;
  settings.maximumLength = 12.5;
  settings.kinds = {true, false, true, true, false, false, true, false, true, false};
  settings.coloring = RayColoring::Face;
  rays.show(settings);
  rays.setMaximumLength(33.0);
  rays.showStatus("77 points");
  lines.tree("rays of an object", rays);
  for (QAbstractButton* button : rays.findChildren<QAbstractButton*>()) button->click();
  for (QComboBox* combo : rays.findChildren<QComboBox*>()) {
    combo->setCurrentIndex(combo->count() - 1);
    emit combo->activated(combo->currentIndex());
  }
  for (const char* object : {"desk", "other"}) {
    rays.setObjects({"hall", object});
    lines.tree(std::string("rays with ") + object, rays);
  }
  for (const QString& line : told) lines.add("rays", line);

  SurfaceViewPanel surfaces;
  told.clear();
  QObject::connect(&surfaces, &SurfaceViewPanel::changed, [&](const SurfaceViewSettings& s) {
    told += QString("%1 %2 %3").arg(s.view).arg(s.low.value_or(-1.0)).arg(s.high.value_or(-1.0));
  });
  surfaces.showRange({0.25, 4.0});
  lines.tree("surfaces", surfaces);
  auto* lock = surfaces.findChild<QCheckBox*>("rangeLock");
  for (int view = 0; view < static_cast<int>(surfaceViews().size()); view += 3) {
    surfaces.choose(view);
    lock->click();
    const auto* low = surfaces.findChild<ValueField*>("rangeLow");
    told += QString("%1 %2 %3").arg(lock->isChecked()).arg(low->isEnabled()).arg(low->text());
  }
  surfaces.showRange({5.0, 2.0});
  lock->click();
  lock->click();
  surfaces.show({4, 1.5, 2.5});
  told += lock->isChecked() ? "locked" : "free";
  for (const QString& line : told) lines.add("surfaces", line);

  ExplainCard card([](const std::string&) { return nullptr; });
  card.showHint("<point> at it");
  lines.tree("card", card);
  lines.add("card says", card.text());
  card.setPinned(true);
  card.QWidget::show();
  card.show(room.explain(), {Phrase::plain("Off."), Mend{Phrase::plain("Widen it"), "room", room.probe}}, 1.0);
  lines.tree("card pinned", card);
  lines.add("card says", card.text());
  FootprintView footprint;
  lines.tree("footprint", footprint);
  lines.add("footprint of 400", footprint.heightForWidth(400));
}

void addOutliner(ValueLines& lines) {
  ViewState state;
  OutlinerModel model(state);
  auto loaded = std::make_shared<Model>();
  loaded->materials.resize(4);
  for (int i = 0; i < 4; ++i) {
    auto& material = loaded->materials[static_cast<std::size_t>(i)];
    material.name = "m" + std::to_string(i);
    material.emissive = {i == 1 ? 0.5f : 0.1f, i == 2 ? 0.6f : 0.2f, i == 3 ? 0.7f : 0.3f};
  }
  loaded->meshes.resize(5);
  for (int i = 0; i < 4; ++i) loaded->meshes[static_cast<std::size_t>(i)].material = i;
  loaded->meshes[4].material = -1;
  for (const auto& [node, mesh] : {std::pair{"wall", 0},
                                   {"red lamp", 1},
                                   {"green lamp", 2},
                                   {"blue lamp", 3},
                                   {"bare", 4},
                                   {"", 0},
                                   {"desk", 0}}) {
    Instance instance;
    instance.node = node;
    instance.mesh = mesh;
    loaded->instances.push_back(instance);
  }
  model.setModels({loaded, loaded});
  Scene scene = twoProbes();
  const char* const probes[] = {"hall/a", "hall/b c", "den 1", "den", "x y", "x z", "/q", "q/", "r 2"};
  scene.probes.resize(9, scene.probes[0]);
  for (std::size_t i = 0; i < 9; ++i) scene.probes[i].name = probes[i];
  scene.lights.resize(3);
  scene.lights[0].type = LightType::Point;
  scene.lights[1].type = LightType::Spot;
  scene.lights[2].type = LightType::Directional;
  scene.cameras.resize(2);
  scene.cameras[0].name = "from the door";
  scene.cameras[1].name = "above";
  QStringList signals_;
  QObject::connect(&model, &OutlinerModel::renamed, [&](const QModelIndex& row, const QString& name) {
    signals_ += QString::fromStdString(model.name(row)) + " to " + name;
  });
  QObject::connect(&model, &QAbstractItemModel::dataChanged,
                   [&](const QModelIndex& a, const QModelIndex& b, const QVector<int>& roles) {
                     QString text = QString("rows %1 to %2, column %3").arg(a.row()).arg(b.row()).arg(b.column());
                     for (const int role : roles) text += QString(" %1").arg(role);
                     signals_ += text;
                   });
  QObject::connect(&model, &QAbstractItemModel::modelReset, [&] { signals_ += "reset"; });
  const std::function<void(const std::string&, const QModelIndex&, int)> add =
      [&](const std::string& what, const QModelIndex& parent, int level) {
        for (int row = 0; row < model.rowCount(parent); ++row) {
          const QModelIndex at = model.index(row, 0, parent);
          QString text = QString(2 * level, ' ') + model.data(at, Qt::DisplayRole).toString();
          text += " '" + model.data(at, Qt::EditRole).toString() + "' kind " +
                  QString::number(static_cast<int>(model.kind(at))) + " place " + QString::number(model.place(at)) +
                  (model.isGroup(at) ? " group" : "");
          text += model.data(at, Qt::DecorationRole).isValid() ? " icon" : "";
          text += model.data(at, Qt::FontRole).value<QFont>().bold() ? " bold" : "";
          text += model.data(at, Qt::ForegroundRole).isValid() ? " dim" : "";
          text += " (" + model.data(at, Qt::ToolTipRole).toString() + ")";
          for (const int column : {1, 2}) {
            const QModelIndex mark = at.siblingAtColumn(column);
            text += " [" + model.data(mark, Qt::AccessibleTextRole).toString() +
                    (model.data(mark, Qt::DecorationRole).isValid() ? " icon" : "") + " " +
                    model.data(mark, Qt::ToolTipRole).toString().left(9) +
                    QString(" %1").arg(static_cast<int>(model.flags(mark))) +
                    (model.data(mark, Qt::DisplayRole).isValid() ? " text" : "") + "]";
          }
          text += QString(" flags %1").arg(static_cast<int>(model.flags(at)));
          for (const auto part : {ViewState::Part::Probe, ViewState::Part::Object}) {
            QStringList under;
            for (const std::string& name : model.namesUnder(at, part)) under += QString::fromStdString(name);
            text += " {" + under.join(",") + "}";
          }
          lines.add(what, text);
          if (!(model.parent(at) == parent)) lines.add(what, "has another parent");
          add(what, at, level + 1);
        }
      };
  model.show(scene, {});
  add("tree", {}, 0);
  model.showStates({bakeStateLook(scene.probes[0], BakeState::Stale, true),
                    bakeStateLook(scene.probes[1], BakeState::UpToDate, false)});
  model.markShown(1);
  model.markShown(1);
  state.setHidden(ViewState::Part::Probe, {"hall/a", "den"}, true);
  state.setLocked(ViewState::Part::Object, {"wall", "desk", "bare"}, true);
  state.setLocked(ViewState::Part::Probe, {"hall/a", "hall/b c"}, true);
  model.stateChanged();
  add("marked", {}, 0);
  model.show(scene, "LAMP");
  add("found", {}, 0);
  model.show(scene, "a");
  add("found a", {}, 0);
  scene.probes[1].name = "hall/other";
  model.show(scene, {});
  scene.cameras[1].name = "below";
  model.show(scene, {});
  const QModelIndex camera = model.index(1, 0, model.group(OutlinerModel::Kind::Cameras)), wall = model.object("wall");
  for (const QModelIndex& row : {camera, wall, model.probe(0)}) {
    const bool taken[] = {model.setData(row, "new name", Qt::EditRole), model.setData(row, "shown", Qt::DisplayRole),
                          model.setData(row.siblingAtColumn(1), "no name", Qt::EditRole)};
    lines.add("set", QString("%1 %2 %3").arg(taken[0]).arg(taken[1]).arg(taken[2]));
  }
  for (const QString& signal : signals_) lines.add("signal", signal);
  lines.add("nothing", QString("%1 %2 %3 %4 %5")
                           .arg(model.probe(99).isValid())
                           .arg(model.object("none").isValid())
                           .arg(model.index(0, 3).isValid())
                           .arg(model.index(-1, 0).isValid())
                           .arg(model.rowCount(wall.siblingAtColumn(1))));
  for (const ProbeMode mode : {ProbeMode::Baked, ProbeMode::Realtime, ProbeMode::Custom}) {
    Probe probe = scene.probes[0];
    probe.mode = mode;
    probe.image = "some/where/sky.exr";
    for (int state_ = 0; state_ <= static_cast<int>(BakeState::FromFile); ++state_) {
      for (const bool stopped : {false, true}) {
        const BakeStateLook look = bakeStateLook(probe, static_cast<BakeState>(state_), stopped);
        lines.add("bake state", QString("%1 %2 %3").arg(look.text, look.color.name()).arg(look.filled));
      }
    }
  }
}

void addPlaced(ValueLines& lines) {
  PlacedEntry plain, pictured;
  plain.name = "hall";
  plain.reason = "As it is";
  pictured.name = "kitchen";
  pictured.reason = "One for the room";
  pictured.gain = "Error 0.2 to 0.1";
  pictured.details = "3.0 x 2.0 x 4.0";
  for (int i = 0; i < PlacedPictures::kCount; ++i) {
    pictured.pictures.images[static_cast<std::size_t>(i)] = someColors(90 + 8 * i, 60);
  }
  PlacedList list;
  int changes = 0;
  QObject::connect(&list, &PlacedList::changed, [&changes] { ++changes; });
  list.show({plain, pictured});
  lines.tree("placed", list);
  list.findChild<QCheckBox*>("placedProbe1")->click();
  lines.add("ticked",
            QString("%1 %2 %3, %4 changes").arg(list.ticked(0)).arg(list.ticked(1)).arg(list.ticked(2)).arg(changes));
  for (const QToolButton* button : list.findChildren<QToolButton*>()) {
    const QSize size = button->icon().availableSizes().value(0);
    lines.add("thumbnail", QString("%1 x %2").arg(size.width()).arg(size.height()));
  }
  const PlacedPicturesDialog dialog(pictured, nullptr);
  lines.tree("placed pictures", dialog);
  for (const QLabel* label : dialog.findChildren<QLabel*>()) {
    lines.add("picture", label->text().isEmpty() ? QString::number(label->sizeHint().width()) : QString("words"));
  }
}

TEST(PanelWidgetValues, OfExplanationsRowsAndListsAreAsBefore) {
  if (!widgetLinesHold()) GTEST_SKIP() << "kept for another Qt than " << qVersion();
  ValueLines lines;
  addExplain(lines);
  addOutliner(lines);
  addPlaced(lines);
  expectKeptWidgets("gui/values/panel_widget_values.txt", lines.lines());
}

}  // namespace
}  // namespace boxprobe
