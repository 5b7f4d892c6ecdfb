// The files opened last, kept between runs. Called by the file commands; knows no document.
#pragma once

#include <QStringList>

namespace boxprobe {

/// Those that are still there, the newest first.
QStringList recentFiles();
/// `path` becomes the newest. A settings folder that cannot be written only forgets.
void rememberFile(const QString& path);

}  // namespace boxprobe
