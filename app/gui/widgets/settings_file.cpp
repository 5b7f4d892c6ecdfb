// See settings_file.h.
#include "app/gui/widgets/settings_file.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <exception>
#include <utility>

namespace boxprobe {

namespace {

QStringList& remarks() {
  static QStringList lines;
  return lines;
}

/// What a file was as it was last found readable.
struct Tried {
  QDateTime modified;
  qint64 size = -1;
  bool operator==(const Tried& other) const { return modified == other.modified && size == other.size; }
};

bool readable(const QString& path) {
  try {
    const QSettings settings(path, QSettings::IniFormat);
    for (const QString& key : settings.allKeys()) settings.value(key);
    return settings.status() == QSettings::NoError;
  } catch (const std::exception&) {
    return false;
  }
}

/// False if it had to stay where it is.
bool keptAside(const QString& path) {
  QString aside = path + ".unreadable";
  for (int copy = 2; QFileInfo::exists(aside); ++copy) aside = path + ".unreadable-" + QString::number(copy);
  const bool kept = QFile::rename(path, aside);
  const QString line =
      kept
          ? QCoreApplication::translate("Settings",
                                        "%1: cannot be read as settings; it is kept as %2, and settings start anew")
          : QCoreApplication::translate(
                "Settings", "%1: cannot be read as settings, nor renamed to %2; settings last until the window closes");
  remarks() += line.arg(path, aside);
  return kept;
}

}  // namespace

// By QStandardPaths, not QSettings' own place: tests redirect the former.
QString settingsPath(const QString& name) {
  return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/" + name;
}

std::unique_ptr<QSettings> openSettings(const QString& name) {
  static QHash<QString, Tried> tried;
  static QHash<QString, QString> instead;  // of files that stay unreadable where they are
  static const QTemporaryDir own;
  const QString path = settingsPath(name);
  const QFileInfo file(path);
  const Tried now{file.lastModified(), file.size()};
  if (file.exists() && !(tried.value(path) == now)) {
    instead.remove(path);
    if (!readable(path) && !keptAside(path)) instead[path] = own.filePath(name);
    tried[path] = now;
  }
  return std::make_unique<QSettings>(instead.value(path, path), QSettings::IniFormat);
}

QStringList takeSettingsRemarks() {
  return std::exchange(remarks(), {});
}

}  // namespace boxprobe
