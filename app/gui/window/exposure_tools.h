// Exposure at hand beside the picture: in the tool bar, and by menu and keys. Called by the main window; what it edits
// goes through the control's editor.
#pragma once

#include <QObject>

#include "app/gui/edit/editor.h"

class QMainWindow;

namespace boxprobe {

class ExposureControl;
class MenuBar;

class ExposureTools : public QObject {
  Q_OBJECT

 public:
  /// Adds to the window's tool bar.
  ExposureTools(Editor& editor, MenuBar& menu, QMainWindow* window);
  /// The document changed.
  void update();

 signals:
  /// The picture is to be measured.
  void automaticWanted();

 private:
  void setBackground(int chosen, QWidget* over);

  Editor& editor_;
  MenuBar& menu_;
  ExposureControl* control_;
};

}  // namespace boxprobe
