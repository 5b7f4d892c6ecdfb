// Marks of probes and objects, copies of probes, selections that follow edits: every number and name, and who is told.
#include <gtest/gtest.h>

#include <cmath>

#include "app/gui/edit/editor.h"
#include "app/gui/edit/probe_copies.h"
#include "app/gui/edit/view_state.h"

namespace boxprobe {
namespace {

using Names = ViewState::Names;
using Part = ViewState::Part;

class ViewStateValues : public ::testing::Test {
 protected:
  ViewStateValues() {
    QObject::connect(&state_, &ViewState::changed, [this] { ++told_; });
    state_.follow(named({"a", "b", "c"}), {"x", "y", "z"});
    told_ = 0;
  }
  static std::vector<Probe> named(const std::vector<std::string>& names) {
    std::vector<Probe> probes(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) probes[i].name = names[i];
    return probes;
  }
  int told() { return std::exchange(told_, 0); }
  /// Of probes, then of objects: hidden, left out, locked.
  std::string marks() const {
    std::string text;
    for (const auto& [part, names] :
         {std::pair(Part::Probe, Names{"a", "b", "c", "d"}), std::pair(Part::Object, Names{"x", "y", "z"})}) {
      for (const std::string& name : names) {
        const std::string mark = std::string(state_.hidden(part, name) ? "h" : "") +
                                 (state_.shown(part, name) ? "" : "-") + (state_.locked(part, name) ? "l" : "");
        if (!mark.empty()) text += name + mark + " ";
      }
    }
    for (const std::string& name : state_.objects()) text += "*" + name + " ";
    return text;
  }

  ViewState state_;
  int told_ = 0;
};

TEST_F(ViewStateValues, WhoeverIsToldHasSomethingNew) {
  EXPECT_EQ(marks(), "");
  state_.setHidden(Part::Probe, {"b"}, true);
  EXPECT_EQ(marks(), "bh- ");
  EXPECT_EQ(told(), 1);
  EXPECT_TRUE(state_.anyHidden());
  EXPECT_FALSE(state_.anyLocked());
  state_.setHidden(Part::Probe, {"b"}, true);
  state_.setHidden(Part::Probe, {}, false);
  EXPECT_EQ(told(), 0);
  state_.setHidden(Part::Object, {"x", "z"}, true);
  state_.setLocked(Part::Object, {"y"}, true);
  state_.setLocked(Part::Probe, {"c"}, true);
  EXPECT_EQ(marks(), "bh- cl xh- yl zh- ");
  EXPECT_TRUE(state_.anyLocked());
  EXPECT_EQ(told(), 3);
  state_.selectObjects({"y"});
  state_.selectObjects({"y"});
  EXPECT_EQ(marks(), "bh- cl xh- yl zh- *y ");
  EXPECT_EQ(told(), 1);
  EXPECT_FALSE(state_.isolated());
  state_.isolate({"b"}, {"z"});
  EXPECT_TRUE(state_.isolated());
  EXPECT_EQ(marks(), "a- bh c-l d- xh- y-l zh *y ");
  state_.isolate({"b"}, {"z"});
  EXPECT_EQ(told(), 1);
  state_.isolate({"b"}, {"y"});
  EXPECT_EQ(told(), 1);
  state_.endIsolation();
  state_.endIsolation();
  EXPECT_EQ(told(), 1);
  EXPECT_EQ(marks(), "bh- cl xh- yl zh- *y ");
  state_.setHidden(Part::Object, {"x"}, false);
  EXPECT_EQ(marks(), "bh- cl yl zh- *y ");
  EXPECT_EQ(told(), 1);
  state_.showAll();
  state_.showAll();
  EXPECT_EQ(marks(), "cl yl *y ") << "locks stay";
  EXPECT_EQ(told(), 1);
  EXPECT_FALSE(state_.anyHidden());
  state_.isolate({}, {"z"});
  told();
  state_.showAll();
  EXPECT_FALSE(state_.isolated());
  EXPECT_EQ(told(), 1);
  state_.setCutaway(true);
  state_.setCutaway(true);
  EXPECT_EQ(told(), 1);
  EXPECT_TRUE(state_.cutaway());
  state_.forget();
  EXPECT_EQ(told(), 1);
  EXPECT_EQ(marks(), "");
  EXPECT_TRUE(state_.cutaway()) << "that is of no scene";
  state_.forget();
  EXPECT_EQ(told(), 0);
  // Each of them alone is something to forget.
  state_.selectObjects({"x"});
  told();
  state_.forget();
  EXPECT_EQ(told(), 1);
  state_.setLocked(Part::Probe, {"a"}, true);
  told();
  state_.forget();
  EXPECT_EQ(told(), 1);
  state_.isolate({"a"}, {});
  told();
  state_.forget();
  EXPECT_EQ(told(), 1);
  EXPECT_FALSE(state_.isolated());
}

TEST_F(ViewStateValues, MarksGoWithTheirProbe) {
  state_.setHidden(Part::Probe, {"a"}, true);
  state_.setLocked(Part::Probe, {"a", "c"}, true);
  state_.setHidden(Part::Object, {"x", "y"}, true);
  state_.selectObjects({"y", "z"});
  told();
  state_.follow(named({"a", "b", "c"}), {"x", "y", "z"});
  EXPECT_EQ(told(), 0) << "nothing is new";
  state_.follow(named({"d", "b", "c"}), {"x", "y", "z"});
  EXPECT_EQ(marks(), "cl dh-l xh- yh- *y *z ");
  EXPECT_EQ(told(), 1);
  state_.follow(named({"c", "b", "d"}), {"x", "y", "z"});
  EXPECT_EQ(marks(), "cl dh-l xh- yh- *y *z ") << "they only changed their places";
  EXPECT_EQ(told(), 0);
  state_.follow(named({"c", "b"}), {"x", "y", "z"});
  EXPECT_EQ(marks(), "cl xh- yh- *y *z ") << "one has gone";
  EXPECT_EQ(told(), 1);
  state_.follow(named({"a", "b", "d"}), {"x", "y", "z"});
  EXPECT_EQ(marks(), "xh- yh- *y *z ") << "another number of probes: nobody knows which was which";
  EXPECT_EQ(told(), 1);
  state_.follow(named({"a", "b", "d"}), {"y", "q"});
  EXPECT_EQ(marks(), "yh- *y ") << "of another model";
  EXPECT_EQ(told(), 1);
  state_.isolate({"a", "b"}, {"y"});
  told();
  state_.follow(named({"c", "b", "d"}), {"y", "q"});
  EXPECT_EQ(marks(), "a- d- x- yh z- *y ") << "what is isolated is renamed, too";
  EXPECT_EQ(told(), 1);
}

Probe turnedProbe() {
  Probe probe;
  probe.name = "room";
  probe.box = {glm::dvec3(-1.0, 0.5, 2.0), glm::dvec3(3.0, 2.5, 5.0)};
  probe.influence = Box{glm::dvec3(-2.0, 0.25, 1.0), glm::dvec3(4.0, 3.0, 7.0)};
  probe.origin = {0.5, 1.0, 3.0};
  probe.rotationDegrees = {0.0, 30.0, 0.0};
  return probe;
}

TEST(ProbeCopiesValues, EachStandsATenthOfTheWidthFarther) {
  Scene scene;
  scene.probes = {turnedProbe()};
  ProbeCopies copies(scene);
  // 4 wide: steps of 0.4 along the box's X, which a turn by 30 degrees about Y has brought to (cos, 0, -sin).
  const double pi = std::acos(-1.0);
  const glm::dvec3 step = 0.4 * glm::dvec3(std::cos(pi / 6.0), 0.0, -std::sin(pi / 6.0));
  const Probe original = turnedProbe();
  const auto expectAt = [&](const Probe& copy, double steps, const char* name) {
    SCOPED_TRACE(name);
    EXPECT_EQ(copy.name, name);
    for (int axis = 0; axis < 3; ++axis) {
      const double by = steps * step[axis];
      EXPECT_NEAR(copy.origin[axis], original.origin[axis] + by, 1e-9);
      EXPECT_NEAR(copy.box.min[axis], original.box.min[axis] + by, 1e-9);
      EXPECT_NEAR(copy.box.max[axis], original.box.max[axis] + by, 1e-9);
      EXPECT_NEAR(copy.influence->min[axis], original.influence->min[axis] + by, 1e-9);
      EXPECT_NEAR(copy.influence->max[axis], original.influence->max[axis] + by, 1e-9);
      EXPECT_EQ(copy.rotationDegrees[axis], original.rotationDegrees[axis]);
    }
  };
  expectAt(copies.add(original), 1.0, "room 2");
  expectAt(copies.add(original), 2.0, "room 3");
  Probe other = original;
  other.name = "hall";
  other.influence.reset();
  const Probe named = copies.add(other);
  EXPECT_EQ(named.name, "hall") << "a free name stays";
  EXPECT_FALSE(named.influence.has_value()) << "its own, not that of what stood there before";
  EXPECT_NEAR(named.origin.x, original.origin.x + 3.0 * step.x, 1e-9);
  // Where none stands it stays.
  Probe free = original;
  free.origin.y += 1.0;
  EXPECT_EQ(copies.add(free).origin, free.origin);
  Probe thin = original;
  thin.rotationDegrees = {0.0, 0.0, 0.0};
  EXPECT_EQ(copies.add(thin).origin, thin.origin) << "turned otherwise it can be told apart";
  EXPECT_NEAR(copies.add(thin).origin.x, thin.origin.x + 0.4, 1e-9);
  EXPECT_EQ(copies.add(thin).origin.z, thin.origin.z);
}

class EditorSelection : public ::testing::Test {
 protected:
  EditorSelection() {
    Scene scene;
    for (const char* name : {"a", "b", "c", "d"}) {
      Probe probe;
      probe.name = name;
      scene.probes.push_back(probe);
    }
    document_.open(scene, "");
    QObject::connect(&editor_, &Editor::selectionChanged, [this] { log_ += "selection "; });
    QObject::connect(&editor_, &Editor::settled, [this] { log_ += "settled "; });
    QObject::connect(&editor_, &Editor::probesAsked, [this] { log_ += "asked "; });
    QObject::connect(&editor_, &Editor::failed, [this](const QString&) { log_ += "failed "; });
  }
  /// What was told since, and who is selected: the one that is shown in brackets.
  std::string now() {
    std::string text = std::exchange(log_, {});
    for (const std::size_t index : editor_.selected()) {
      const std::string name = document_.scene().probes[index].name;
      text += index == document_.selectedProbe() ? "[" + name + "]" : name;
    }
    return text;
  }
  void remove(const std::vector<std::string>& names) {
    editor_.commit("Remove", [names](Scene& scene) {
      for (const std::string& name : names) {
        if (const auto at = findProbe(scene, name)) scene.probes.erase(scene.probes.begin() + static_cast<int>(*at));
      }
    });
  }
  void rename(const std::string& from, const std::string& to) {
    editor_.commit("Rename", [from, to](Scene& scene) { scene.probes[*findProbe(scene, from)].name = to; });
  }

  Document document_;
  Editor editor_{document_};
  std::string log_;
};

TEST(ProbeCopiesValues, ACopyOfACopyStandsWhereNoneStands) {
  // Two steps from the original lead where one step from its copy leads, but for rounding.
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    Scene scene;
    Probe original = turnedProbe();
    original.rotationDegrees = {0.0, 0.0, 0.0};
    original.box.min.x = -1.86 + 0.085 * k;
    original.box.max.x = 3.91 + 0.044 * k;
    original.origin.x = original.box.min.x + 0.37;
    scene.probes = {original};
    ProbeCopies copies(scene);
    const Probe second = copies.add(original), third = copies.add(original);
    scene.probes.insert(scene.probes.end(), {second, third});
    const double step = 0.1 * original.box.size().x;
    EXPECT_NEAR(ProbeCopies(scene).add(second).box.min.x, original.box.min.x + 3.0 * step, 1e-9);
  }
}

TEST_F(EditorSelection, GoesWithClicksAndEdits) {
  editor_.selectProbe({});
  EXPECT_EQ(now().find('['), std::string::npos);
  EXPECT_EQ(editor_.selectedName(), "");
  editor_.selectProbe(1);
  EXPECT_EQ(now(), "selection asked [b]");
  EXPECT_EQ(editor_.selectedName(), "b");
  editor_.selectProbe(1);
  EXPECT_EQ(now(), "asked [b]");
  editor_.selectProbes({0, 2});
  EXPECT_EQ(now(), "selection asked a[c]") << "the last one is shown";
  EXPECT_EQ(editor_.selectedName(), "2 probes");
  editor_.selectProbes({0, 2}, 0);
  EXPECT_EQ(now(), "selection asked [a]c");
  editor_.selectProbes({0, 2}, 3);
  EXPECT_EQ(now(), "selection asked a[c]") << "one that is not among them";
  editor_.toggleProbe(3);
  EXPECT_EQ(now(), "selection asked ac[d]");
  editor_.toggleProbe(0);
  EXPECT_EQ(now(), "selection asked c[d]");
  editor_.toggleProbe(3);
  EXPECT_EQ(now(), "selection asked [c]");
  editor_.toggleProbe(2);
  EXPECT_EQ(now(), "[c]") << "one is left";
  editor_.selectProbes({1, 2, 3}, 2);
  now();

  rename("c", "e");
  EXPECT_EQ(now(), "selection settled b[e]d");
  rename("a", "f");
  EXPECT_EQ(now(), "settled b[e]d");
  editor_.undo();
  EXPECT_EQ(now(), "settled b[e]d");
  editor_.undo();
  EXPECT_EQ(now(), "selection settled b[c]d");
  editor_.goTo(2);
  EXPECT_EQ(now(), "selection settled b[e]d");
  editor_.goTo(0);
  now();
  remove({"b", "d"});
  EXPECT_EQ(now(), "selection settled [c]");
  editor_.undo();
  EXPECT_EQ(now(), "selection asked selection settled b[d]") << "those that came back";
  editor_.redo();
  const std::string after = now();
  EXPECT_EQ(after.substr(after.find_last_of(' ') + 1).size(), 3u) << after;
  editor_.undo();
  editor_.selectProbe(0);
  now();
  remove({"a"});
  editor_.selectProbe(2);
  now();
  editor_.undo();
  EXPECT_EQ(now(), "selection asked selection settled [a]");
  editor_.selectProbe(2);
  editor_.commit("All", [](Scene& scene) { scene.probes.clear(); });
  now();
  editor_.commit("One", [](Scene& scene) {
    scene.probes.resize(1);
    scene.probes[0].name = "only";
  });
  EXPECT_EQ(now(), "settled ");
}

TEST_F(EditorSelection, EditsGoToThoseThatAreSelected) {
  const auto brighter = [](Probe& probe) { probe.intensity += 1.0; };
  const auto intensities = [this] {
    std::string text;
    for (const Probe& probe : document_.scene().probes) text += std::to_string(static_cast<int>(probe.intensity));
    return text;
  };
  int control = 0;
  editor_.selectProbe({});
  editor_.commitProbe({&control}, "Set", brighter);
  editor_.previewProbe({&control}, "Set", brighter);
  editor_.commitOne("Set", brighter);
  EXPECT_EQ(intensities(), "1111");
  EXPECT_FALSE(document_.canUndo());
  editor_.selectProbe(1);
  editor_.commitProbe({&control}, "Set", brighter);
  EXPECT_EQ(intensities(), "1211");
  editor_.selectProbes({0, 1, 3});
  editor_.previewProbe({&control}, "Preview", brighter);
  EXPECT_EQ(intensities(), "2312");
  EXPECT_TRUE(editor_.previews({&control, 0, "d"}));
  EXPECT_TRUE(document_.previewing());
  editor_.cancel();
  EXPECT_EQ(intensities(), "1211");
  EXPECT_FALSE(document_.previewing());
  editor_.previewProbe({&control}, "Preview", brighter);
  editor_.finish();
  EXPECT_EQ(intensities(), "2312");
  EXPECT_EQ(document_.undoLabel(), "Preview");
  editor_.commitOne("One", brighter);
  EXPECT_EQ(intensities(), "2313");
  now();
  editor_.commit("Bad", [](Scene& scene) { scene.exposure = -1.0; });
  EXPECT_EQ(now(), "failed settled ab[d]");
  EXPECT_EQ(document_.undoLabel(), "One");
}

}  // namespace
}  // namespace boxprobe
