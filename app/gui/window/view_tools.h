// What is done with the picture beside editing probes: it is compared with others, clicked, exposed, and explained by a
// list of keys over it.
#pragma once

#include <QImage>
#include <QObject>

#include "app/gui/view/picture_compare.h"
#include "app/gui/view/view_commands.h"
#include "app/gui/window/picture_menu.h"
#include "filters/core/scene/model.h"

class QLabel;
class QMainWindow;

namespace boxprobe {

class ViewComparison;
class Workspace;

class ViewTools : public QObject {
  Q_OBJECT

 public:
  ViewTools(Workspace& workspace, QMainWindow* window);

  ViewCommands& views() const;
  PictureMenu& pictureMenu() { return *pictureMenu_; }
  PictureCompare& compare() { return *compare_; }
  ViewComparison& sideBySide() { return *sideBySide_; }
  /// Ends whichever comparison is under way; false without one.
  bool stopComparing();

 private:
  void connectCompare();
  void connectSideBySide();
  /// One comparison at a time: both stand in the place of the picture.
  void comparisonChanged();
  void showKeys(bool shown);
  QImage barePicture();
  ImageRgbaF bareLight(const QSize& size);

  Workspace& workspace_;
  PictureMenu* pictureMenu_;
  PictureCompare* compare_;
  ViewComparison* sideBySide_;
  QLabel* keys_ = nullptr;
};

}  // namespace boxprobe
