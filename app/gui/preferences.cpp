// See preferences.h.
#include "app/gui/preferences.h"

#include <QSettings>
#include <QStandardPaths>

namespace boxprobe {

namespace {

constexpr const char* kCheaperWhileMoving = "cheaperWhileMoving";

/// By QStandardPaths, not QSettings' own place: tests redirect the former.
QString settingsFile() {
  return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/preferences.ini";
}

}  // namespace

std::optional<bool> cheaperWhileMoving() {
  const QVariant value = QSettings(settingsFile(), QSettings::IniFormat).value(kCheaperWhileMoving);
  return value.isValid() ? std::optional<bool>(value.toBool()) : std::nullopt;
}

void keepCheaperWhileMoving(bool on) {
  QSettings(settingsFile(), QSettings::IniFormat).setValue(kCheaperWhileMoving, on);
}

}  // namespace boxprobe
