// Sessions with the handles of probes: each one hovered over, pulled with each key held, nudged, hidden, locked; of one
// probe and of two. See session_values_test.cpp.
#include <gtest/gtest.h>

#include <QMenu>

#include "app/gui/edit/view_state.h"
#include "app/gui/handles/probe_widget.h"
#include "app/gui/view/viewport.h"
#include "app/gui/window/picture_menu.h"
#include "filters/vtk/widgets/handle_picking.h"
#include "tests/gui/session_record.h"

namespace boxprobe {
namespace {

const char* kindName(HandleKind kind) {
  const char* const names[] = {"face", "origin", "influence", "blend", "arrow", "move", "ring"};
  return names[static_cast<int>(kind)];
}

/// Beside handles and objects.
const QPointF kNowhere{4.0, 4.0};

class SessionHandlesTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    putCamera({5.1, 4.6, 5.9}, {0.2, 1.1, -0.9});
    forget();
  }

  /// A pixel of the handle's that is nearest to it and no other.
  std::optional<QPointF> gripOf(const Handle& handle) {
    const auto& probes = document().scene().probes;
    const auto points = handleGripWorld(probes[handle.probe], handle, window_->viewport().view());
    for (const glm::dvec3& point : points) {
      const auto pixel = window_->viewport().view().pixel(point);
      if (!pixel) continue;
      const auto under = handleAt(probes, document().selectedProbe(), window_->viewport().view(), *pixel, 12.0,
                                  window_->probeWidget().mode());
      if (under && *under == handle) return QPointF(pixel->x, pixel->y);
    }
    return std::nullopt;
  }

  void pullEach(const char* mode) {
    const Qt::KeyboardModifiers held[] = {{}, Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier};
    const char* const names[] = {"", " Shift", " Ctrl", " Alt"};
    std::size_t number = 0;
    for (const Handle& handle :
         handles(document().scene().probes, document().selectedProbe(), window_->probeWidget().mode())) {
      if (handle.probe != document().selectedProbe()) continue;
      const std::string name = std::string(mode) + " " + kindName(handle.kind) + " " + faceName(handle.face);
      const auto grip = gripOf(handle);
      if (!grip) {
        lines_.push_back(name + " is behind others");
        continue;
      }
      move(*grip);
      note(name + ", over it");
      const Qt::KeyboardModifiers keys = held[number % 4];
      press(*grip, keys);
      note("pressed");
      move(*grip + QPointF(13.0, -9.0), keys);
      note(std::string("pulled") + names[number % 4]);
      release(*grip + QPointF(17.0, 12.0), keys);
      note("let go");
      if (document().canUndo()) key(Qt::Key_Z, Qt::ControlModifier);
      note("undone");
      ++number;
    }
  }

  void nudgeEach(const std::string& where) {
    for (const auto& [pressed, name] :
         {std::pair(Qt::Key_Right, "right"), std::pair(Qt::Key_Left, "left"), std::pair(Qt::Key_Up, "up"),
          std::pair(Qt::Key_Down, "down"), std::pair(Qt::Key_PageUp, "page up"),
          std::pair(Qt::Key_PageDown, "page down")}) {
      const bool fine = pressed == Qt::Key_Left || pressed == Qt::Key_PageUp;
      key(pressed, fine ? Qt::ShiftModifier : Qt::NoModifier);
      note(where + ", nudged " + name);
    }
    undoAll();
    note("undone");
  }
};

TEST_F(SessionHandlesTest, EachHandleIsPulled) {
  window_->editor().selectProbe(0);
  for (const auto& [pressed, name] : {std::pair(Qt::Key_1, "box"), std::pair(Qt::Key_2, "influence"),
                                      std::pair(Qt::Key_3, "origin"), std::pair(Qt::Key_4, "place")}) {
    key(pressed);
    note(name);
    pullEach(name);
  }
  expectKept();
}

TEST_F(SessionHandlesTest, DragsEndInEachWay) {
  window_->editor().selectProbe(0);
  const Handle face{HandleKind::Face, 0, {0, true}}, origin{HandleKind::Origin, 0, {}};
  const QPointF grip = *gripOf(face), middle = *gripOf(origin);
  move(grip);
  press(grip);
  move(grip + QPointF(10.0, 0.0));
  key(Qt::Key_Escape);
  note("Escape");
  move(grip + QPointF(20.0, 0.0));
  release(grip + QPointF(20.0, 0.0));
  note("let go after it");
  press(grip);
  move(grip + QPointF(10.0, 0.0));
  document().undo();
  note("undone meanwhile");
  release(grip + QPointF(20.0, 0.0));
  note("let go after it");
  move(grip);
  press(grip);
  press(grip, {}, Qt::RightButton);
  move(grip + QPointF(10.0, 4.0));
  release(grip + QPointF(10.0, 4.0), {}, Qt::RightButton);
  note("the right button meanwhile");
  key(Qt::Key_2);
  note("another mode meanwhile");
  release(grip + QPointF(10.0, 4.0));
  key(Qt::Key_1);
  undoAll();
  note("as before");
  for (const auto& [letter, name] : {std::pair(Qt::Key_X, "X"), std::pair(Qt::Key_Y, "Y"), std::pair(Qt::Key_Z, "Z")}) {
    move(middle);
    press(middle);
    move(middle + QPointF(14.0, 9.0));
    note("origin");
    keyDown(letter);
    note(std::string(name) + " held");
    move(middle + QPointF(22.0, -3.0));
    note("farther");
    keyUp(letter);
    note("no longer held");
    if (letter == Qt::Key_Y) keyDown(Qt::Key_X);
    if (letter == Qt::Key_Y) window_->setFocus();
    release(middle + QPointF(22.0, -3.0));
    if (letter == Qt::Key_Y) window_->viewport().setFocus();
    note("let go");
    undoAll();
  }
  click(middle);
  note("a click on it");
  click(middle, Qt::ControlModifier);
  note("with Ctrl");
  move(middle);
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&window_->viewport(), &leave);
  note("left");
  move(kNowhere);
  note("beside");
  move(middle);
  choose("View > Probe boxes and handles");
  note("no handles");
  move(middle + QPointF(1.0, 0.0));
  key(Qt::Key_Right);
  note("moved over none");
  choose("View > Probe boxes and handles");
  move(kNowhere);
  note("handles");
  expectKept();
}

TEST_F(SessionHandlesTest, SeveralProbes) {
  window_->editor().selectProbe(0);
  forget();
  const Handle other{HandleKind::Origin, 1, {}};
  const QPointF at = *gripOf(other);
  move(at);
  note("over the other");
  click(at);
  note("clicked");
  const QPointF first = *gripOf({HandleKind::Origin, 0, {}});
  click(first, Qt::ControlModifier);
  note("both");
  for (const auto& [pressed, kind] :
       {std::pair(Qt::Key_4, HandleKind::Move), std::pair(Qt::Key_4, HandleKind::Turn),
        std::pair(Qt::Key_3, HandleKind::OriginAxis), std::pair(Qt::Key_3, HandleKind::Origin),
        std::pair(Qt::Key_2, HandleKind::Influence), std::pair(Qt::Key_1, HandleKind::Face)}) {
    key(pressed);
    const std::size_t selected = *document().selectedProbe();
    const auto grip = gripOf({kind, selected, kind == HandleKind::Origin ? BoxFace{} : BoxFace{0, true}});
    if (!grip) {
      lines_.push_back(std::string(kindName(kind)) + " is behind others");
      continue;
    }
    drag(*grip, *grip + QPointF(15.0, 8.0), {}, 2);
    note(std::string("both by a ") + kindName(kind));
    if (document().canUndo()) key(Qt::Key_Z, Qt::ControlModifier);
    note("undone");
  }
  key(Qt::Key_4);
  nudgeEach("both");
  key(Qt::Key_1);
  click(*gripOf({HandleKind::Origin, *document().selectedProbe(), {}}), Qt::ControlModifier);
  note("taken out");
  key(Qt::Key_A, Qt::ControlModifier);
  note("all");
  key(Qt::Key_H);
  note("hidden");
  move(at);
  note("over what is hidden");
  key(Qt::Key_H, Qt::AltModifier);
  note("shown");
  window_->editor().selectProbe(0);
  window_->viewState().setLocked(ViewState::Part::Probe, {"corner"}, true);
  note("locked");
  move(at);
  note("over what is locked");
  click(at);
  note("clicked");
  window_->viewState().setLocked(ViewState::Part::Probe, {"corner"}, false);
  key(Qt::Key_Slash);
  note("isolated");
  key(Qt::Key_Slash);
  note("no longer");
  window_->viewState().selectObjects({"mirror"});
  key(Qt::Key_Slash);
  note("with the mirror");
  key(Qt::Key_H);
  note("the mirror hidden");
  key(Qt::Key_H, Qt::AltModifier);
  note("shown");
  window_->editor().selectProbe({});
  key(Qt::Key_H);
  key(Qt::Key_Slash);
  key(Qt::Key_Right);
  note("nothing selected");
  expectKept();
}

TEST_F(SessionHandlesTest, Nudges) {
  window_->editor().selectProbe(0);
  nudgeEach("aslant");
  key(Qt::Key_4);
  nudgeEach("the whole");
  key(Qt::Key_1);
  putCamera({-6.0, 3.0, 1.0}, {0.0, 1.0, 0.0});
  nudgeEach("from the left");
  choose("View > Look along an axis > From +Y");
  nudgeEach("from above");
  choose("View > Look along an axis > From -Z");
  nudgeEach("from behind");
  putCamera({5.1, 4.6, 5.9}, {0.2, 1.1, -0.9});
  for (const BoxFace& face : kBoxFaces) {
    const auto grip = gripOf({HandleKind::Face, 0, face});
    if (!grip) continue;
    move(*grip);
    nudgeEach(std::string("over ") + faceName(face));
  }
  // Held, it is one step; another key within is part of it.
  move(kNowhere);
  keyDown(Qt::Key_Right);
  keyDown(Qt::Key_Up);
  note("two held");
  keyUp(Qt::Key_Up);
  note("one let go");
  keyDown(Qt::Key_Left);
  document().undo();
  note("undone meanwhile");
  keyUp(Qt::Key_Left);
  keyUp(Qt::Key_Right);
  note("none held");
  expectKept();
}

TEST_F(SessionHandlesTest, ClicksAndMenusOfThePicture) {
  auto* menus = window_->findChild<PictureMenu*>();
  window_->editor().selectProbe(0);
  forget();
  for (const QPointF& at : {QPointF(240.0, 200.0), QPointF(60.0, 60.0), QPointF(300.0, 240.0), QPointF(180.0, 230.0),
                            QPointF(10.0, 330.0)}) {
    click(at);
    note("click at " + roundedText(at.x()) + " " + roundedText(at.y()));
    lines_.push_back("menu: " + entriesOf(*menus->menuAt(at)));
    doubleClick(at);
    note("double click");
  }
  const QPointF spot(240.0, 200.0), other = *gripOf({HandleKind::Origin, 1, {}});
  const auto does = [&](const char* name, const QPointF& at) {
    const auto menu = menus->menuAt(at);
    for (QAction* action : menu->actions()) {
      if (QString(action->text()).remove('&').startsWith(name)) action->trigger();
    }
    note(std::string("menu > ") + name);
  };
  lines_.push_back("menu: " + entriesOf(*menus->menuAt(other)));
  note("menu of the other");
  window_->editor().selectProbes({0, 1});
  window_->viewState().selectObjects({});
  lines_.push_back("menu: " + entriesOf(*menus->menuAt(spot)));
  note("menu of both");
  does("Show in the panels", spot);
  does("Leave out", spot);
  lines_.push_back("menu: " + entriesOf(*menus->menuAt(spot)));
  does("Leave out", spot);
  does("Hide", spot);
  lines_.push_back("menu: " + entriesOf(*menus->menuAt(spot)));
  does("Show all hidden", spot);
  does("Show it alone", spot);
  lines_.push_back("menu: " + entriesOf(*menus->menuAt(spot)));
  does("Show the others again", spot);
  window_->editor().selectProbe({});
  lines_.push_back("menu: " + entriesOf(*menus->menuAt(spot)));
  does("Show it alone", spot);
  does("Show all hidden", spot);
  window_->viewState().setLocked(ViewState::Part::Object, {"floor", "sphere 5"}, true);
  click(spot);
  note("click on what is locked");
  window_->viewState().setLocked(ViewState::Part::Object, {"floor", "sphere 5"}, false);
  putCamera({0.1, 1.5, 0.2}, {0.0, 1.2, -3.0});
  choose("Edit > Select the probe here");
  note("here, within");
  putCamera({3.0, 1.5, -2.0}, {0.0, 1.2, -3.0});
  choose("Edit > Select the probe here");
  note("here, in the corner");
  putCamera({30.0, 1.5, 40.0}, {0.0, 1.2, -3.0});
  choose("Edit > Select the probe here");
  note("here, outside");
  doubleClick({5.0, 5.0});
  note("double click on the sky");
  expectKept();
}

}  // namespace
}  // namespace boxprobe
