// See file_commands.h.
#include "app/gui/window/file_commands.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QStandardPaths>
#include <QUrl>
#include <algorithm>
#include <exception>

#include "app/gui/edit/work_beside.h"
#include "app/gui/view/motion_preview.h"
#include "app/gui/view/picture_export.h"
#include "app/gui/view/picture_work.h"
#include "app/gui/view/viewport.h"
#include "app/gui/view/workspace.h"
#include "app/gui/widgets/message_box.h"
#include "app/gui/widgets/phrase_words.h"
#include "app/gui/widgets/recent_files.h"
#include "app/gui/widgets/window_words.h"
#include "filters/core/base/errors.h"
#include "filters/core/scene/lesson.h"
#include "filters/core/scene/scene_fields.h"
#include "filters/io/cube/sky_picture.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/json/json_text.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/import/model_reader.h"
#include "filters/vtk/scene/object_memory.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

namespace {

constexpr const char* kSceneSuffix = ".boxprobe.json";

bool canOpen(const QString& path) {
  return path.endsWith(".json", Qt::CaseInsensitive) || isModelPath(path.toStdString());
}

/// What cannot be drawn must be found out while the open scene can still stay.
void requireDrawable(const LoadedScene& loaded) {
  if (const auto* image = std::get_if<SkyImage>(&loaded.scene.sky)) loadSkyPicture(*image);
  requireMemoryForObjects(loaded.scene, loaded.models);
}

}  // namespace

FileCommands::FileCommands(Workspace& workspace, QWidget* window)
    : QObject(window),
      workspace_(workspace),
      document_(workspace.document()),
      editor_(workspace.editor()),
      window_(window) {
  constexpr int kSettleMilliseconds = 400;
  settle_.setSingleShot(true);
  settle_.setInterval(kSettleMilliseconds);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, &settle_, QOverload<>::of(&QTimer::start));
  connect(&settle_, &QTimer::timeout, this, &FileCommands::changedOnDisk);
  connect(this, &FileCommands::message, &workspace, &Workspace::message);
  connect(&workspace, &Workspace::opened, this, &FileCommands::offerVariants);
  connect(&workspace, &Workspace::filed, this, &FileCommands::offerRecent);
  const Actions& actions = workspace.actions();
  connect(actions.open, &QAction::triggered, this, &FileCommands::open);
  connect(actions.reload, &QAction::triggered, this, &FileCommands::reload);
  connect(actions.sky, &QAction::triggered, this, &FileCommands::chooseSky);
  connect(actions.save, &QAction::triggered, this, &FileCommands::save);
  connect(actions.saveAs, &QAction::triggered, this, &FileCommands::saveAs);
  connect(actions.exportImage, &QAction::triggered, this, &FileCommands::exportImage);
  offerRecent();
}

// What is chosen is done later: it makes the menu anew.
void FileCommands::offerRecent() {
  QMenu* menu = workspace_.actions().recent;
  menu->clear();
  const QStringList paths = recentFiles();
  for (int i = 0; i < paths.size(); ++i) {
    const QString& path = paths[i];
    QAction* action = menu->addAction(QString("&%1  %2").arg(i + 1).arg(QString(path).replace('&', "&&")));
    connect(
        action, &QAction::triggered, this, [this, path] { openPath(path); }, Qt::QueuedConnection);
  }
  menu->setEnabled(!paths.isEmpty());
}

void FileCommands::offerVariants(const LoadedScene& loaded) {
  QMenu* menu = workspace_.actions().variants;
  menu->clear();
  const auto variants = loaded.models.empty() ? std::vector<std::string>() : loaded.models.front()->variants;
  menu->setEnabled(!variants.empty());
  if (variants.empty()) return;
  const std::string shown = loaded.scene.models.empty() ? std::string() : loaded.scene.models.front().variant;
  const auto offer = [&](const QString& text, const std::string& name) {
    QAction* action = menu->addAction(text);
    action->setCheckable(true);
    action->setChecked(name == shown);
    connect(
        action, &QAction::triggered, this, [this, name] { openVariant(QString::fromStdString(name)); },
        Qt::QueuedConnection);
  };
  offer(tr("The file's own"), {});
  for (const std::string& name : variants) offer(QString::fromStdString(name).replace('&', "&&"), name);
}

QString FileCommands::nameInFolder() const {
  const QString folder = workspace_.folderShown(), name = workspace_.displayName();
  return folder.isEmpty() ? name : tr("%1 in %2").arg(name, folder);
}

void FileCommands::showError(const QString& title, const QString& line) {
  warnUser(window_, title, line);
}

bool FileCommands::confirmLeaving() {
  emit workspace_.ownSceneWanted();
  editor_.finish();
  if (!document_.modified()) return true;
  const auto answer = askUser(window_, tr("Unsaved changes"),
                              document_.path().empty() && document_.scene().models.empty()
                                  ? tr("Save the changes?")
                                  : tr("Save the changes to %1?").arg(nameInFolder()),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

void FileCommands::open() {
  const QString path = QFileDialog::getOpenFileName(window_, tr("Open"), workspace_.folder(),
                                                    tr("Scenes and models (*.boxprobe.json *.json %1);;Scenes "
                                                       "(*.boxprobe.json *.json);;Models (%1)")
                                                        .arg(QString::fromStdString(modelFilePatterns())));
  if (!path.isEmpty()) openPath(path);
}

void FileCommands::openModel() {
  const QString path = QFileDialog::getOpenFileName(window_, tr("New from a model"), workspace_.folder(),
                                                    tr("Models (%1)").arg(QString::fromStdString(modelFilePatterns())));
  if (!path.isEmpty()) openPath(path);
}

bool FileCommands::openPath(const QString& path) {
  return openWith(path, {});
}

void FileCommands::openVariant(const QString& variant) {
  const auto& models = document_.scene().models;
  const std::string& path = document_.path();
  if (models.empty()) return;
  const std::string name = formatJson(Json(variant.toStdString()));
  std::vector<std::string> assignments = {"models.0.variant=" + name};
  if (path.empty()) {
    // As the bare model is read now.
    for (const char* field : {"unit", "upAxis"}) {
      const FieldRow<ModelFile>& row = fieldNamed(modelFields(), field);
      const auto choice = static_cast<std::size_t>(std::get<int>(row.get(models.front())));
      assignments.push_back("models.0." + std::string(field) + "=" + std::string(row.choices.at(choice).id));
    }
  }
  openWith(QString::fromStdString(path.empty() ? models.front().file : path), assignments);
}

bool FileCommands::busy() {
  if (workBesideRuns()) emit message(tr("Wait until what is being read or fitted is done"));
  return workBesideRuns();
}

LoadedScene FileCommands::load(const QString& path, const std::vector<std::string>& assignments) {
  FitWishes wishes;
  wishes.aspect = workspace_.aspect();
  LoadedScene loaded;
  workBeside(window_, tr("Loading %1").arg(QFileInfo(path).fileName()), true, [&](const BesideProgress& progress) {
    loaded = loadScene(path.toStdString(), assignments, progress, wishes);
    requireDrawable(loaded);
    if (!progress(1.0)) throw LoadCancelled(path.toStdString() + ": loading was cancelled");
  });
  return loaded;
}

bool FileCommands::openWith(const QString& path, const std::vector<std::string>& assignments) {
  if (busy()) return false;
  try {
    LoadedScene loaded = load(path, assignments);
    // Not before: a file that proves broken asks nothing.
    if (!confirmLeaving()) return false;
    const QString warning = loaded.warnings.empty() ? QString() : QString::fromStdString(loaded.warnings.front());
    const std::size_t more = loaded.warnings.empty() ? 0 : loaded.warnings.size() - 1;
    const std::string digest = loaded.fileDigest;
    const QString decided = loaded.fit ? phraseWords(loaded.fit->decided) : QString();
    workspace_.showScene(loaded);
    workspace_.viewport().setFocus();  // keys are for the picture, not for the first field there is
    assignments_ = assignments;
    remember(path, digest);
    emit message(warning.isEmpty() ? (decided.isEmpty() ? tr("Opened %1").arg(path) : decided)
                 : more == 0       ? windowWords(warning)
                 : more == 1       ? tr("%1 (and 1 more warning)").arg(windowWords(warning))
                                   : tr("%1 (and %2 more warnings)").arg(windowWords(warning)).arg(more));
    return true;
  } catch (const LoadCancelled&) {
    emit message(tr("Loading cancelled; the scene is unchanged."));
    return false;
  } catch (const std::exception& error) {
    if (!QFileInfo::exists(path)) {
      forgetFile(path);
      offerRecent();
    }
    showError(tr("Cannot open"), QString::fromStdString(messageOf(error)));
    return false;
  }
}

void FileCommands::openSky(const QString& path) {
  if (busy()) return;
  try {
    loadSkyPicture(SkyImage{path.toStdString()});
  } catch (const std::exception& error) {
    return showError(tr("No sky"), QString::fromStdString(messageOf(error)));
  }
  const std::string file = QFileInfo(path).absoluteFilePath().toStdString();
  editor_.commit(tr("Sky from %1").arg(QFileInfo(path).fileName()),
                 [file](Scene& scene) { scene.sky = SkyImage{file}; });
  emit message(tr("%1 is the sky; turn it under Sky and lights").arg(QFileInfo(path).fileName()));
}

void FileCommands::chooseSky() {
  const QString path = QFileDialog::getOpenFileName(window_, tr("Sky from a picture"), workspace_.folder(),
                                                    tr("Pictures of a sky (*.hdr *.exr)"));
  if (!path.isEmpty()) openSky(path);
}

namespace {

QDateTime newest(const QStringList& files) {
  QDateTime time;
  for (const QString& file : files) time = std::max(time, QFileInfo(file).lastModified());
  return time;
}

}  // namespace

// The scene's file and its models'. Saving replaces a file by another of its name, which ends the watch on it.
void FileCommands::watchFiles() {
  QStringList files;
  if (!document_.path().empty()) files += QString::fromStdString(document_.path());
  for (const ModelFile& model : document_.scene().models) files += QString::fromStdString(model.file);
  if (!watcher_.files().isEmpty()) watcher_.removePaths(watcher_.files());
  if (!files.isEmpty()) watcher_.addPaths(files);
  known_ = newest(files);
}

void FileCommands::changedOnDisk() {
  // A lesson is on show, something is being dragged or opened: later.
  if (workBesideRuns() || workspace_.lesson() != nullptr || document_.previewing()) return settle_.start();
  QStringList files = {QString::fromStdString(document_.path())};
  for (const ModelFile& model : document_.scene().models) files += QString::fromStdString(model.file);
  if (newest(files) <= known_) return watchFiles();
  // What could be redone are changes, too.
  if (!document_.modified() && !document_.canUndo() && !document_.canRedo()) return reload();
  watchFiles();
  emit message(
      tr("%1 changed on disk. Your changes stay; File > Reload takes the file instead").arg(workspace_.displayName()));
}

void FileCommands::reload() {
  if (busy()) return;
  if (workspace_.lesson() != nullptr) return emit message(tr("A lesson is on show; leave it to read the file again"));
  const auto& models = document_.scene().models;
  const std::string path = document_.path().empty() && !models.empty() ? models.front().file : document_.path();
  if (path.empty()) return;
  editor_.finish();
  // Not "Save?": that would write over what the file has become.
  if (document_.modified() &&
      askUser(window_, tr("Reload"), tr("Discard your changes and read %1 again?").arg(nameInFolder()),
              QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel) != QMessageBox::Discard) {
    return;
  }
  try {
    const LoadedScene loaded = load(QString::fromStdString(path), assignments_);
    workspace_.setDigestAsRead(loaded.fileDigest);
    showAgain(loaded);
    emit message(tr("Read %1 again").arg(QString::fromStdString(path)));
    return watchFiles();
  } catch (const LoadCancelled&) {
    emit message(tr("Loading cancelled; the scene is unchanged."));
  } catch (const std::exception& error) {
    emit message(tr("Not read again: %1").arg(QString::fromStdString(messageOf(error))));
  }
  watchFiles();
}

void FileCommands::remember(const QString& path, const std::string& digest) {
  workspace_.setDigestAsRead(digest);
  rememberFile(path);
  watchFiles();
  emit workspace_.filed();
}

void FileCommands::showAgain(const LoadedScene& loaded) {
  const Camera view = workspace_.renderer().currentCamera();
  const Probe* selected = editor_.probe();
  const std::string name = selected != nullptr ? selected->name : std::string();
  workspace_.showScene(loaded);
  if (const auto index = findProbe(document_.scene(), name)) document_.selectProbe(index);
  workspace_.renderer().applyCamera(view);
  emit workspace_.viewport().cameraMoved();
}

bool FileCommands::save() {
  return document_.path().empty() ? saveAs() : saveTo(QString::fromStdString(document_.path()));
}

bool FileCommands::saveAs() {
  const auto& models = document_.scene().models;
  const QString own = !document_.path().empty() ? QFileInfo(QString::fromStdString(document_.path())).fileName()
                      : models.empty()
                          ? QString()
                          : QFileInfo(QString::fromStdString(models.front().file)).completeBaseName() + kSceneSuffix;
  QString path = QFileDialog::getSaveFileName(window_, tr("Save as"), QDir(workspace_.folder()).filePath(own),
                                              tr("Scenes (*%1)").arg(kSceneSuffix));
  if (path.isEmpty()) return false;
  if (!path.endsWith(".json", Qt::CaseInsensitive)) {
    path += kSceneSuffix;
    if (!mayOverwrite(window_, tr("Save as"), path)) return false;
  }
  return saveTo(path);
}

// Whatever stands there and is not what was read or saved is somebody else's.
bool FileCommands::mayReplace(const QString& path) {
  const std::string digest = fileDigest(path.toStdString());
  if (digest == workspace_.digestAsRead() || !QFileInfo::exists(path)) return true;
  const QString question =
      workspace_.digestAsRead().empty()
          ? tr("%1 already exists, and is not the file that these changes were made to. Replace it?")
          : tr("%1 changed on disk. Replace it by yours?");
  return askUser(window_, tr("Save"), question.arg(path)) == QMessageBox::Yes;
}

bool FileCommands::mayWrite(const QString& path) const {
  const Lesson* lesson = workspace_.lesson();
  const QString wanted = QFileInfo(path).canonicalFilePath();
  if (lesson == nullptr || wanted.isEmpty()) return true;
  const auto isIt = [&](const std::string& scene) {
    return QFileInfo(QString::fromStdString(scene)).canonicalFilePath() == wanted;
  };
  return !isIt(lesson->scene) && std::none_of(lesson->steps.begin(), lesson->steps.end(),
                                              [&](const LessonStep& step) { return isIt(step.scene); });
}

bool FileCommands::saveTo(const QString& path) {
  editor_.finish();
  try {
    if (!mayWrite(path)) throw InputError(path.toStdString() + ": the lesson stands on this file; choose another name");
    if (path.toStdString() == document_.path() && !mayReplace(path)) return false;
    saveSceneFile(document_.scene(), path.toStdString());
    document_.markSaved(path.toStdString());
    remember(path, fileDigest(path.toStdString()));
    emit message(tr("Saved %1").arg(path));
    return true;
  } catch (const std::exception& error) {
    showError(tr("Cannot save"), QString::fromStdString(messageOf(error)));
    return false;
  }
}

std::optional<FileCommands::Recovery> FileCommands::recovery() const {
  if (!document_.modified() || workspace_.lesson() != nullptr) return std::nullopt;
  const auto& models = document_.scene().models;
  const std::string& origin = document_.path().empty() && !models.empty() ? models.front().file : document_.path();
  const QFileInfo file(QString::fromStdString(origin));
  const QString stem = file.fileName().section('.', 0, 0) + ".recovered";
  QString folder = file.absolutePath();
  if (!QFileInfo(folder).isWritable()) {
    folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    QDir(folder).mkpath(".");
  }
  QString path = QDir(folder).filePath(stem + kSceneSuffix);
  // One from before is the user's by now.
  for (int copy = 2; QFileInfo::exists(path); ++copy) {
    path = QDir(folder).filePath(stem + "-" + QString::number(copy) + kSceneSuffix);
  }
  return Recovery{path.toStdString(), sceneText(document_.scene(), folder.toStdString())};
}

bool FileCommands::recover(const Autosave::Kept& kept) {
  try {
    LoadedScene loaded = loadScene(kept.scene.toStdString());
    requireDrawable(loaded);
    if (!confirmLeaving()) return false;
    loaded.path = kept.original.toStdString();
    loaded.unsaved = true;
    workspace_.showScene(loaded);
    assignments_.clear();
    workspace_.setDigestAsRead(kept.originalDigest);
    watchFiles();
    emit message(tr("Recovered %1; save it to keep it").arg(nameInFolder()));
    return true;
  } catch (const std::exception& error) {
    showError(tr("Cannot recover"), QString::fromStdString(messageOf(error)));
    return false;
  }
}

std::string FileCommands::saveRecovery() {
  emit workspace_.ownSceneWanted();
  editor_.finish();
  const auto unsaved = recovery();
  if (!unsaved) return {};
  writeTextAtomically(unsaved->path, unsaved->text);
  return unsaved->path;
}

void FileCommands::exportImage() {
  QString path = QFileDialog::getSaveFileName(window_, tr("Export image"), workspace_.folder(),
                                              tr("Display colours (*.png);;Linear light (*.exr)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) {
    path += ".png";
    if (!mayOverwrite(window_, tr("Export image"), path)) return;
  }
  try {
    workspace_.picture().motion().rest();
    emit workspace_.documentSceneWanted();
    exportPicture(path.toStdString(), workspace_.renderer(), workspace_.viewport(), workspace_.shownHandles());
    workspace_.requestPicture();
    emit message(tr("Wrote %1").arg(path));
  } catch (const std::exception& error) {
    showError(tr("Cannot export"), QString::fromStdString(messageOf(error)));
  }
}

QString FileCommands::droppedSky(const QMimeData* data) {
  if (!data->hasUrls()) return {};
  for (const QUrl& url : data->urls()) {
    QString path = url.toLocalFile();
    if (path.endsWith(".hdr", Qt::CaseInsensitive) || path.endsWith(".exr", Qt::CaseInsensitive)) return path;
  }
  return {};
}

QString FileCommands::droppedFile(const QMimeData* data) {
  if (!data->hasUrls()) return {};
  for (const QUrl& url : data->urls()) {
    if (url.isLocalFile() && canOpen(url.toLocalFile())) return url.toLocalFile();
  }
  return {};
}

}  // namespace boxprobe
