// The outliner's tree of names and the window's marks on them, without a window: groups by room, what is found, what
// it costs, and that marks follow names.
#include "app/gui/panels/outliner_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>

#include "tests/unit/two_probes.h"

namespace boxprobe {
namespace {

using Kind = OutlinerModel::Kind;
using Part = ViewState::Part;
using Names = ViewState::Names;

Scene sceneOf(const std::vector<std::string>& names) {
  Scene scene = twoProbes();
  const Probe first = scene.probes.front();
  scene.probes.clear();
  for (const std::string& name : names) {
    scene.probes.push_back(first);
    scene.probes.back().name = name;
  }
  return scene;
}

std::shared_ptr<const Model> modelOf(const std::vector<std::string>& nodes, const std::string& lamp) {
  auto model = std::make_shared<Model>();
  model->materials.resize(2);
  model->materials[0].name = "plaster";
  model->materials[1].name = "glow";
  model->materials[1].emissive = {2.0f, 1.0f, 0.5f};
  model->meshes.resize(2);
  model->meshes[0].material = 0;
  model->meshes[1].material = 1;
  for (const std::string& node : nodes) {
    Instance instance;
    instance.node = node;
    instance.mesh = node == lamp ? 1 : 0;
    model->instances.push_back(instance);
  }
  return model;
}

/// The tree as text: two blanks a level.
std::string text(const OutlinerModel& model, const QModelIndex& parent = {}, int level = 0) {
  std::string lines;
  for (int i = 0; i < model.rowCount(parent); ++i) {
    const QModelIndex row = model.index(i, 0, parent);
    const std::string name = model.isGroup(row) && model.kind(row) != Kind::Room
                                 ? "#" + std::to_string(static_cast<int>(model.kind(row)))
                                 : model.name(row);
    lines += std::string(static_cast<std::size_t>(2 * level), ' ') + name + "\n" + text(model, row, level + 1);
  }
  return lines;
}

TEST(OutlinerModel, ProbesStandInGroupsByRoom) {
  const Scene scene = sceneOf({"hall", "room 1 a", "bath/mirror", "room 2", "room 1 b", "hall 2", "den c", "7", "/x"});
  EXPECT_EQ(probeGroups(scene.probes),
            (std::vector<std::string>{"hall", "room 1", "bath", "", "room 1", "hall", "", "", ""}));
  ViewState state;
  OutlinerModel model(state);
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  Scene bare = scene;
  bare.lights.clear();
  bare.cameras.clear();
  model.show(bare, {});
  EXPECT_EQ(
      text(model),
      "#0\n  hall\n    hall\n    hall 2\n  room 1\n    room 1 a\n    room 1 b\n  bath\n    bath/mirror\n  room 2\n"
      "  den c\n  7\n  /x\n");
  EXPECT_EQ(model.namesUnder(model.probe(1).parent(), Part::Probe), (Names{"room 1 a", "room 1 b"}));
  EXPECT_EQ(model.name(model.probe(5)), "hall 2");
  const auto shown = [&](std::size_t probe) { return model.data(model.probe(probe), Qt::DisplayRole).toString(); };
  EXPECT_EQ(shown(2), "mirror") << "\"bath\" stands above it";
  EXPECT_EQ(model.data(model.probe(2), Qt::EditRole).toString(), "bath/mirror");
  EXPECT_EQ(shown(1), "room 1 a");
  EXPECT_EQ(shown(8), "/x");
  model.show(bare, "ROOM 1");
  EXPECT_EQ(text(model), "#0\n  room 1\n    room 1 a\n    room 1 b\n");
  EXPECT_FALSE(model.probe(5).isValid());
  EXPECT_EQ(model.probesShown(), (std::vector<std::size_t>{1, 4}));
}

TEST(OutlinerModel, WhatShinesIsALampAndFollowsItsMaterial) {
  ViewState state;
  OutlinerModel model(state);
  model.setModels({modelOf({"wall", "bulb", "desk"}, "bulb")});
  Scene scene = sceneOf({"a"});
  model.show(scene, {});
  EXPECT_EQ(model.kind(model.object("bulb")), Kind::Lamp);
  EXPECT_EQ(model.kind(model.object("desk")), Kind::Object);
  scene.materials["glow"].emissive = glm::vec3(0.0f);
  model.show(scene, {});
  EXPECT_EQ(model.kind(model.object("bulb")), Kind::Object);
  EXPECT_FALSE(model.group(Kind::Lamps).isValid());
}

// Filling and finding look at each name once, however many there are; and what is the same is not made anew.
TEST(OutlinerModel, FillingAndFindingAreLinear) {
  const auto examined = [](int count, const QString& words) {
    std::vector<std::string> names;
    for (int i = 0; i < count; ++i) names.push_back("room " + std::to_string(i / 3) + " " + char('a' + i % 3));
    ViewState state;
    OutlinerModel model(state);
    Scene scene = sceneOf(names);
    scene.lights.clear();
    scene.cameras.clear();
    model.show(scene, words);
    int resets = 0;
    QObject::connect(&model, &QAbstractItemModel::modelReset, [&resets] { ++resets; });
    const std::size_t once = model.namesExamined();
    model.show(scene, words);
    EXPECT_EQ(resets, 0);
    EXPECT_EQ(model.namesExamined(), once) << "the names are the same";
    return once;
  };
  EXPECT_EQ(examined(300, {}), 300u);
  EXPECT_EQ(examined(300, "room 7"), 300u);
  EXPECT_EQ(examined(1200, {}), 1200u);
}

TEST(OutlinerModel, ARenamedProbeKeepsTheTreeAsItIs) {
  ViewState state;
  OutlinerModel model(state);
  Scene scene = sceneOf({"x", "y"});
  model.show(scene, {});
  int resets = 0, changes = 0;
  QObject::connect(&model, &QAbstractItemModel::modelReset, [&resets] { ++resets; });
  QObject::connect(&model, &QAbstractItemModel::dataChanged, [&changes] { ++changes; });
  scene.probes[1].name = "z";
  model.show(scene, {});
  EXPECT_EQ(model.name(model.probe(1)), "z");
  EXPECT_EQ(resets, 0);
  EXPECT_GT(changes, 0);
}

TEST(ViewState, MarksFollowRenamedProbesAndForgetThoseThatAreGone) {
  ViewState state;
  Scene scene = sceneOf({"a", "b", "c"});
  const Names nodes{"wall", "desk"};
  state.follow(scene.probes, nodes);
  state.setHidden(Part::Probe, {"b"}, true);
  state.setLocked(Part::Probe, {"c"}, true);
  state.setHidden(Part::Object, {"wall"}, true);
  scene.probes[1].name = "hall";
  state.follow(scene.probes, nodes);
  EXPECT_TRUE(state.hidden(Part::Probe, "hall"));
  EXPECT_FALSE(state.hidden(Part::Probe, "b"));
  scene.probes.pop_back();
  state.follow(scene.probes, {"desk"});
  scene = sceneOf({"a", "hall", "c"});
  state.follow(scene.probes, nodes);
  EXPECT_FALSE(state.locked(Part::Probe, "c")) << "another probe of that name";
  EXPECT_FALSE(state.hidden(Part::Object, "wall"));
}

TEST(ViewState, IsolatingLeavesWhatWasHiddenAsItWas) {
  ViewState state;
  state.setHidden(Part::Object, {"wall"}, true);
  state.isolate({"a"}, {"wall", "desk"});
  EXPECT_TRUE(state.shown(Part::Object, "wall")) << "it was asked for";
  EXPECT_FALSE(state.shown(Part::Object, "lamp"));
  EXPECT_FALSE(state.shown(Part::Probe, "b"));
  state.endIsolation();
  EXPECT_FALSE(state.shown(Part::Object, "wall"));
  EXPECT_TRUE(state.shown(Part::Probe, "b"));
  int told = 0;
  QObject::connect(&state, &ViewState::changed, [&told] { ++told; });
  state.showAll();
  state.showAll();
  EXPECT_EQ(told, 1) << "once: nothing changes a second time";
  EXPECT_TRUE(state.shown(Part::Object, "wall"));
}

}  // namespace
}  // namespace boxprobe
