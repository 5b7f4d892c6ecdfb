// See autosave.h.
#include "app/gui/window/autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

#include "app/gui/view/workspace.h"
#include "filters/core/base/errors.h"
#include "filters/io/files/absolute_path.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/files/read_file.h"
#include "filters/io/json/json_text.h"
#include "filters/io/scene/scene_file.h"

namespace boxprobe {

namespace {

constexpr const char* kScene = "scene.boxprobe.json";
constexpr const char* kAbout = "about.json";
constexpr const char* kLock = "lock";

QString allFolders() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/unsaved";
}

/// Stale as soon as its process is gone, however young it is.
std::unique_ptr<QLockFile> lockIn(const QString& folder) {
  auto lock = std::make_unique<QLockFile>(QDir(folder).filePath(kLock));
  lock->setStaleLockTime(0);
  return lock;
}

/// What about.json says; nothing if it is no such file.
std::optional<Autosave::Kept> keptIn(const QString& folder) {
  const QString about = QDir(folder).filePath(kAbout);
  const QString scene = QDir(folder).filePath(kScene);
  if (!QFileInfo(scene).isFile() || !QFileInfo(about).isFile()) return std::nullopt;
  try {
    const Json json = parseJsonText(readWholeFile(about.toStdString(), 1 << 20), about.toStdString()).root;
    const auto text = [&json](const char* key) { return QString::fromStdString(json.value(key, std::string())); };
    QString original = text("original");
    // A name that is relative to a folder nobody knows any more could be another file's.
    if (QDir::isRelativePath(original)) original.clear();
    return Autosave::Kept{folder,
                          scene,
                          original,
                          json.value("originalDigest", std::string()),
                          text("name"),
                          text("folder"),
                          QFileInfo(scene).lastModified()};
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace

Autosave::Autosave(Workspace& workspace, QObject* parent)
    : QObject(parent), workspace_(workspace), document_(workspace.document()) {
  constexpr int kSoonMilliseconds = 2000;  // several edits in a row are one file
  soon_.setSingleShot(true);
  soon_.setInterval(kSoonMilliseconds);
  connect(&soon_, &QTimer::timeout, this, &Autosave::write);
  connect(this, &Autosave::failed, &workspace, &Workspace::failed);
  connect(&workspace, &Workspace::anotherComing, this, &Autosave::write);
  connect(&workspace.editor(), &Editor::settled, this, &Autosave::settled);
  workspace.changes().add("autosave", {&Changes::file}, [this](const Changes&) { settled(); });  // saved, opened
}

void Autosave::end() {
  if (!stays_) remove();
  lock_.reset();
}

void Autosave::settled() {
  if (!soon_.isActive()) soon_.start();
}

bool Autosave::write() {
  if (workspace_.lesson() != nullptr) return true;  // what was kept of the own scene stays
  if (document_.previewing()) {
    settled();
    return true;
  }
  if (!document_.modified()) {
    remove();
    return true;
  }
  if (!folder_.isEmpty() && document_.scene() == written_) return true;
  try {
    if (folder_.isEmpty()) {
      const QString folder =
          QDir(allFolders())
              .filePath(
                  QString("%1-%2").arg(QDateTime::currentMSecsSinceEpoch()).arg(QCoreApplication::applicationPid()));
      if (!QDir().mkpath(folder)) throw InputError(folder.toStdString() + ": cannot be made");
      lock_ = lockIn(folder);
      if (!lock_->tryLock(0)) throw InputError(folder.toStdString() + ": cannot be locked");
      folder_ = folder;
    }
    const Json about = {{"original", absolutePath(document_.path())},
                        {"originalDigest", workspace_.digestAsRead()},
                        {"name", workspace_.displayName().toStdString()},
                        {"folder", workspace_.folderShown().toStdString()}};
    writeTextAtomically(QDir(folder_).filePath(kAbout).toStdString(), formatJson(about) + "\n");
    writeTextAtomically(QDir(folder_).filePath(kScene).toStdString(),
                        sceneText(document_.scene(), folder_.toStdString()));
    written_ = document_.scene();
    return true;
  } catch (const std::exception& error) {
    if (!std::exchange(told_, true)) {
      emit failed(tr("Unsaved changes would not survive a crash: %1").arg(QString::fromStdString(messageOf(error))));
    }
    return false;
  }
}

void Autosave::remove() {
  if (folder_.isEmpty()) return;
  lock_.reset();
  QDir(folder_).removeRecursively();
  folder_.clear();
}

std::vector<Autosave::Kept> Autosave::leftBehind() {
  std::vector<Kept> all;
  const QDir folders(allFolders());
  for (const QString& name : folders.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name | QDir::Reversed)) {
    const QString folder = folders.filePath(name);
    const auto lock = lockIn(folder);
    if (!lock->tryLock(0)) continue;  // its process lives
    if (auto kept = keptIn(folder)) all.push_back(std::move(*kept));
  }
  return all;
}

void Autosave::discard(const Kept& kept) {
  QDir(kept.folder).removeRecursively();
}

}  // namespace boxprobe
