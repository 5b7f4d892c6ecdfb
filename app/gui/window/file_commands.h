// Open, save, save as and export from the window: the dialogs, the question about unsaved changes, and errors as one
// line that leaves the open scene as it is.
#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>
#include <optional>
#include <string>

#include "app/gui/window/autosave.h"
#include "app/session/load_scene.h"
#include "filters/core/scene/document.h"

class QMimeData;
class QWidget;

namespace boxprobe {

class Editor;
class Workspace;

class FileCommands : public QObject {
  Q_OBJECT

 public:
  FileCommands(Workspace& workspace, QWidget* window);

  void open();
  /// A bare model, which becomes a new scene.
  void openModel();
  /// After asking about unsaved changes. False if the user kept the scene or the file could not be read.
  bool openPath(const QString& path);
  /// The same again, its first model with the materials of this variant.
  void openVariant(const QString& variant);
  bool save();
  bool saveAs();
  void exportImage();
  /// Of a process that is about to end: unsaved changes go into NAME.recovered.boxprobe.json beside the file, or where
  /// that cannot be written into the user's folder for data. Returns the path, empty if nothing is unsaved. Throws
  /// Error.
  std::string saveRecovery();
  /// The scene kept of a process that ended, in place of its original file. It counts as changed: nothing is written
  /// until the user saves, who is asked first unless the file is still the one that process had opened or saved. False
  /// if the user kept the scene on show or the file could not be read.
  bool recover(const Autosave::Kept& kept);
  struct Recovery {
    std::string path, text;
  };
  /// What saveRecovery() would write now; nothing if nothing is unsaved, or a lesson is shown.
  std::optional<Recovery> recovery() const;
  /// False for a file that the open lesson stands on.
  bool mayWrite(const QString& path) const;
  /// True if nothing is lost by leaving the scene: saved, or the user said so.
  bool confirmLeaving();

  /// The picture becomes the sky, as one step. One that cannot be read changes nothing and is told.
  void openSky(const QString& path);
  /// Asks for the picture.
  void chooseSky();
  /// The file on show again, as it is on disk now; the view stays.
  void reload();

  /// The first picture of a sky in a drop; empty if none.
  static QString droppedSky(const QMimeData* data);
  /// The first file of a drop that can be opened; empty if none.
  static QString droppedFile(const QMimeData* data);

  /// `path`, opened or saved, leads the list of recent files; the scene's file had this fileDigest().
  void remember(const QString& path, const std::string& digest);

 signals:
  void message(const QString& text);

 private:
  void offerRecent();
  /// Of the first model.
  void offerVariants(const LoadedScene& loaded);
  /// The same scene, newly read: the view stays.
  void showAgain(const LoadedScene& loaded);
  void watchFiles();
  void changedOnDisk();
  bool openWith(const QString& path, const std::vector<std::string>& assignments);
  /// In a thread, while the window goes on; throws what loadScene() does.
  /// Says so where something is being read or fitted.
  bool busy();
  LoadedScene load(const QString& path, const std::vector<std::string>& assignments);
  bool saveTo(const QString& path);
  QString nameInFolder() const;
  bool mayReplace(const QString& path);
  void showError(const QString& title, const QString& line);

  Workspace& workspace_;
  Document& document_;
  Editor& editor_;
  QWidget* window_;
  QFileSystemWatcher watcher_;
  QTimer settle_;                         ///< a file is written in several steps
  QDateTime known_;                       ///< of the watched files as they were read or saved
  std::vector<std::string> assignments_;  ///< with which the scene on show was opened
};

}  // namespace boxprobe
