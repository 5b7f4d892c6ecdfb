// See window_language.h.
#include "app/gui/widgets/window_language.h"

#include <QCoreApplication>
#include <QFile>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <memory>

#include "app/gui/translations/translations.h"
#include "app/gui/widgets/preferences.h"

namespace boxprobe {

namespace {

constexpr const char* kLanguage = "language";

/// What is loaded; the translators of the application.
struct Loaded {
  QString code = "en";
  std::vector<std::unique_ptr<QTranslator>> translators;
};

Loaded& loaded() {
  static Loaded now;
  return now;
}

QString fileOf(const QString& code) {
  return ":/translations/boxprobe_" + code + ".qm";
}

QString qtFolder() {
#if QT_VERSION_MAJOR >= 6
  return QLibraryInfo::path(QLibraryInfo::TranslationsPath);
#else
  return QLibraryInfo::location(QLibraryInfo::TranslationsPath);
#endif
}

bool offered(const QString& code) {
  const auto languages = windowLanguages();
  return std::any_of(languages.begin(), languages.end(), [&](const WindowLanguage& each) { return each.code == code; });
}

/// The code of our file for a language of the system's: "zh-Hans-CN" gives "zh_CN"; "" where Chinese is not Simplified.
QString codeOf(const QString& language) {
  QStringList parts = QString(language).replace('_', '-').split('-');
  if (parts.front() != "zh") return parts.front();
  const bool traditional =
      parts.contains("Hant") ||
      (!parts.contains("Hans") && (parts.contains("TW") || parts.contains("HK") || parts.contains("MO")));
  return traditional ? QString() : QString("zh_CN");
}

void install(const QString& file, const QString& folder) {
  auto translator = std::make_unique<QTranslator>();
  if (!translator->load(file, folder)) return;
  QCoreApplication::installTranslator(translator.get());
  loaded().translators.push_back(std::move(translator));
}

}  // namespace

std::vector<WindowLanguage> windowLanguages() {
  openTranslations();
  std::vector<WindowLanguage> languages = {{"en", "English"}};
  for (const WindowLanguage& each :
       {WindowLanguage{"de", "Deutsch"}, WindowLanguage{"zh_CN", QString::fromUtf8("\u7b80\u4f53\u4e2d\u6587")}}) {
    if (QFile::exists(fileOf(each.code))) languages.push_back(each);
  }
  return languages;
}

QString chosenLanguage() {
  const QString code = preferences()->value(kLanguage).toString();
  return offered(code) ? code : QString();
}

void keepLanguage(const QString& code) {
  preferences()->setValue(kLanguage, code);
}

QString languageFor(const QStringList& wanted) {
  for (const QString& language : wanted) {
    const QString code = codeOf(language);
    if (offered(code)) return code;
  }
  return "en";
}

QString loadLanguage(const QString& code) {
  Loaded& now = loaded();
  now.translators.clear();  // each removes itself from the application
  now.code = offered(code) ? code : languageFor(QLocale::system().uiLanguages());
  if (now.code == "en") return now.code;
  install("qtbase_" + now.code, qtFolder());
  install(fileOf(now.code), QString());
  return now.code;
}

QString shownLanguage() {
  return loaded().code;
}

}  // namespace boxprobe
