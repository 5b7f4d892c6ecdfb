// See recent_files.h.
#include "app/gui/widgets/recent_files.h"

#include <QFileInfo>

#include "app/gui/widgets/settings_file.h"

namespace boxprobe {

namespace {

constexpr int kMost = 9;  ///< as many as there are digits for their keys
constexpr const char* kKey = "recentFiles";

constexpr const char* kFile = "recent.ini";

}  // namespace

QStringList recentFiles() {
  return openSettings(kFile)->value(kKey).toStringList();
}

void forgetFile(const QString& path) {
  QStringList files = recentFiles();
  if (files.removeAll(QFileInfo(path).absoluteFilePath()) > 0) openSettings(kFile)->setValue(kKey, files);
}

void rememberFile(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  QStringList files = recentFiles();
  files.removeAll(absolute);
  files.push_front(absolute);
  while (files.size() > kMost) files.pop_back();
  openSettings(kFile)->setValue(kKey, files);
}

}  // namespace boxprobe
