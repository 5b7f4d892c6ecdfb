// What can be told apart of the window after each event of a session: the scene, the selection, the camera, entries of
// menus, docks, headings, what lies over the picture, what the line under it said.
#pragma once

#include <QTemporaryDir>
#include <map>
#include <string>
#include <vector>

#include "tests/gui/window_test.h"

class QMenu;
class QObject;

namespace boxprobe {

/// Rounded, so that no usual number lies on the border between two roundings.
std::string roundedText(double value);
std::string roundedText(const glm::dvec3& value);

class SessionTest : public WindowTest {
 protected:
  /// A picture of 480 x 440 pixels, whatever the fonts are.
  void SetUp() override;
  void TearDown() override;
  LoadedScene scene() const override;

  /// Whether pictures are drawn, and probes captured. Off until a test wants it.
  void setDrawn(bool drawn);
  /// The events of the window that wait are handled first.
  void turn();
  /// A line: what was done, and all that is otherwise than after the last one.
  void note(const std::string& what);
  /// The same state as now is what the next line compares with.
  void forget() {
    known_ = state();
    messages_.clear();
  }
  /// Chooses the entry of that name of the menus ("View > Camera > low").
  void choose(const std::string& entry);
  /// Of a menu: "name", "name on", "(name)" where it is grey, titles of its sections.
  static std::string entriesOf(const QMenu& menu);
  void undoAll();
  /// The lines are those of values/session_CASE.txt.
  void expectKept();

  void wheel(const QPointF& at, int eighths, int sideways = 0);
  void click(const QPointF& at, Qt::KeyboardModifiers modifiers = {});
  void dragWith(Qt::MouseButton button, const QPointF& from, const QPointF& by, Qt::KeyboardModifiers modifiers = {});
  void putCamera(const glm::dvec3& position, const glm::dvec3& target);

  /// "FOLDER" stands for its path in what is noted.
  QString inFolder(const char* name) const { return folder_.filePath(name); }

  std::vector<std::string> lines_;
  QTemporaryDir folder_;

 private:
  std::map<std::string, std::string> state();
  std::string withoutFolders(std::string text) const;
  void addOverlays(std::map<std::string, std::string>& all);

  std::map<std::string, std::string> known_;
  std::vector<std::string> messages_;
  std::vector<QMetaObject::Connection> connections_;
};

}  // namespace boxprobe
