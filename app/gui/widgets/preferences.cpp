// See preferences.h.
#include "app/gui/widgets/preferences.h"

#include <QSettings>
#include <QStandardPaths>
#include <QStringList>

namespace boxprobe {

namespace {

constexpr const char* kGeometry = "windowGeometry";
constexpr const char* kDocks = "windowDocks";
constexpr const char* kFolded = "foldedSections";
constexpr const char* kTheme = "theme";
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

std::optional<int> chosenTheme() {
  const QVariant value = QSettings(preferencesFile(), QSettings::IniFormat).value(kTheme);
  return value.isValid() ? std::optional<int>(value.toInt()) : std::nullopt;
}

void keepTheme(int theme) {
  QSettings(preferencesFile(), QSettings::IniFormat).setValue(kTheme, theme);
}

bool sectionIsFolded(const QString& title) {
  return QSettings(preferencesFile(), QSettings::IniFormat).value(kFolded).toStringList().contains(title);
}

void keepSectionFolded(const QString& title, bool folded) {
  QSettings settings(preferencesFile(), QSettings::IniFormat);
  QStringList titles = settings.value(kFolded).toStringList();
  titles.removeAll(title);
  if (folded) titles.append(title);
  settings.setValue(kFolded, titles);
}

WindowLayout windowLayout() {
  const QSettings settings(preferencesFile(), QSettings::IniFormat);
  return {settings.value(kGeometry).toByteArray(), settings.value(kDocks).toByteArray()};
}

void keepWindowLayout(const QByteArray& geometry, const QByteArray& docks) {
  QSettings settings(preferencesFile(), QSettings::IniFormat);
  settings.setValue(kGeometry, geometry);
  settings.setValue(kDocks, docks);
}

}  // namespace boxprobe
