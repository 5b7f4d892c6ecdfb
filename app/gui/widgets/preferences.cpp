// See preferences.h.
#include "app/gui/widgets/preferences.h"

#include <QSettings>
#include <QStandardPaths>

namespace boxprobe {

namespace {

constexpr const char* kCheaperWhileMoving = "cheaperWhileMoving";

}  // namespace

// By QStandardPaths, not QSettings' own place: tests redirect the former.
QString preferencesFile() {
  return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/preferences.ini";
}

std::optional<bool> cheaperWhileMoving() {
  const QVariant value = QSettings(preferencesFile(), QSettings::IniFormat).value(kCheaperWhileMoving);
  return value.isValid() ? std::optional<bool>(value.toBool()) : std::nullopt;
}

void keepCheaperWhileMoving(bool on) {
  QSettings(preferencesFile(), QSettings::IniFormat).setValue(kCheaperWhileMoving, on);
}

}  // namespace boxprobe
