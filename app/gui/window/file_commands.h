// Open, save, save as and export from the window: the dialogs, the question about unsaved changes, and errors as one
// line that leaves the open scene as it is. Called by the menu, by dropped files and by the closing window.
#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <optional>
#include <string>

#include "app/gui/window/autosave.h"
#include "app/session/load_scene.h"
#include "filters/core/scene/document.h"

class QMimeData;
class QWidget;

namespace boxprobe {

class Editor;

class FileCommands : public QObject {
  Q_OBJECT

 public:
  struct Hooks {
    std::function<void(LoadedScene)> show;                  ///< makes a scene that was read the one on show
    std::function<void(const std::string& path)> exportTo;  ///< writes the picture as PNG or EXR
    /// What is shown for a while in place of the user's own scene goes away.
    std::function<void()> showOwnScene;
    std::function<QString()> borrowedName;              ///< of such a scene; empty: the own one is shown
    std::function<bool(const QString& path)> mayWrite;  ///< false for a file such a scene stands on
    std::function<double()> pictureAspect;              ///< width over height
    std::function<void(LoadedScene)> showAgain;         ///< the same scene, newly read: the view stays
  };

  FileCommands(Document& document, Editor& editor, Hooks hooks, QWidget* window);

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
  /// Name of what is open, for the title: the file's, or the model's of a scene never saved.
  QString displayName() const;
  /// Of the scene's file, or of the model of a scene never saved; empty where neither is, or a lesson is on show.
  QString folderShown() const;
  /// fileDigest() of the scene's file as it was read or saved.
  const std::string& digestAsRead() const { return digestAsRead_; }

  /// `path`, opened or saved, leads the list of recent files; the scene's file had this fileDigest().
  void remember(const QString& path, const std::string& digest);

 signals:
  void message(const QString& text);
  void recentChanged(const QStringList& paths);

 private:
  void watchFiles();
  void changedOnDisk();
  bool openWith(const QString& path, const std::vector<std::string>& assignments);
  /// In a thread, while the window goes on; throws what loadScene() does.
  /// Says so where something is being read or fitted.
  bool busy();
  LoadedScene load(const QString& path, const std::vector<std::string>& assignments);
  bool saveTo(const QString& path);
  QString folder() const;
  QString nameInFolder() const;
  bool mayReplace(const QString& path);
  void showError(const QString& title, const QString& line);

  Document& document_;
  Editor& editor_;
  Hooks hooks_;
  QWidget* window_;
  QFileSystemWatcher watcher_;
  QTimer settle_;                         ///< a file is written in several steps
  QDateTime known_;                       ///< of the watched files as they were read or saved
  std::string digestAsRead_;              ///< of the document's file; empty: there was none, or it is not known
  std::vector<std::string> assignments_;  ///< with which the scene on show was opened
};

}  // namespace boxprobe
