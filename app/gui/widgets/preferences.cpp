// See preferences.h.
#include "app/gui/widgets/preferences.h"

#include <QStringList>

#include "app/gui/widgets/settings_file.h"

namespace boxprobe {

namespace {

constexpr const char* kGeometry = "windowGeometry";
constexpr const char* kDocks = "windowDocks";
constexpr const char* kFolded = "foldedSections";
constexpr const char* kTheme = "theme";
constexpr const char* kCheaperWhileMoving = "cheaperWhileMoving";
constexpr const char* kRefinesAtRest = "refinesAtRest";
constexpr const char* kCutaway = "cutaway";

}  // namespace

std::unique_ptr<QSettings> preferences() {
  return openSettings("preferences.ini");
}

bool cutsAway() {
  return preferences()->value(kCutaway, false).toBool();
}

void keepCutaway(bool on) {
  preferences()->setValue(kCutaway, on);
}

bool refinesAtRest() {
  return preferences()->value(kRefinesAtRest, true).toBool();
}

void keepRefinesAtRest(bool on) {
  preferences()->setValue(kRefinesAtRest, on);
}

std::optional<bool> cheaperWhileMoving() {
  const QVariant value = preferences()->value(kCheaperWhileMoving);
  return value.isValid() ? std::optional<bool>(value.toBool()) : std::nullopt;
}

void keepCheaperWhileMoving(bool on) {
  preferences()->setValue(kCheaperWhileMoving, on);
}

std::optional<int> chosenTheme() {
  const QVariant value = preferences()->value(kTheme);
  bool number = false;
  const int theme = value.toInt(&number);
  return number && theme >= 0 && theme <= 2 ? std::optional<int>(theme) : std::nullopt;
}

void keepTheme(int theme) {
  preferences()->setValue(kTheme, theme);
}

bool sectionIsFolded(const QString& title) {
  return preferences()->value(kFolded).toStringList().contains(title);
}

void keepSectionFolded(const QString& title, bool folded) {
  const auto settings = preferences();
  QStringList titles = settings->value(kFolded).toStringList();
  titles.removeAll(title);
  if (folded) titles.append(title);
  settings->setValue(kFolded, titles);
}

WindowLayout windowLayout() {
  const auto settings = preferences();
  return {settings->value(kGeometry).toByteArray(), settings->value(kDocks).toByteArray()};
}

void keepWindowLayout(const QByteArray& geometry, const QByteArray& docks) {
  const auto settings = preferences();
  settings->setValue(kGeometry, geometry);
  settings->setValue(kDocks, docks);
}

}  // namespace boxprobe
