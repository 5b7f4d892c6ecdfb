// The files opened last, kept between runs. Called by the file commands; knows no document.
#pragma once

#include <QStringList>

namespace boxprobe {

/// The newest first. Not looked for: a network drive that does not answer would keep the window waiting.
QStringList recentFiles();
/// `path` becomes the newest. A settings folder that cannot be written only forgets.
void rememberFile(const QString& path);
/// It is no longer there.
void forgetFile(const QString& path);

}  // namespace boxprobe
