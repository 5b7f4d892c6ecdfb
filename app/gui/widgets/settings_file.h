// The user's settings files. One that cannot be read is kept aside under another name and told once, and its settings
// are those of a first start: no settings file keeps the window from opening.
#pragma once

#include <QSettings>
#include <QString>
#include <QStringList>
#include <memory>

namespace boxprobe {

/// The settings in `name` ("preferences.ini") of the user's folder for settings. QSettings reads a file anew after
/// another process has written it, and ends with an exception at a value such as @Variant() that asks for more memory
/// than there is: every value is tried here first, whenever the file is another one than at the last call.
std::unique_ptr<QSettings> openSettings(const QString& name);

/// Where `name` is kept.
QString settingsPath(const QString& name);

/// One line per file that was kept aside since the last call.
QStringList takeSettingsRemarks();

}  // namespace boxprobe
