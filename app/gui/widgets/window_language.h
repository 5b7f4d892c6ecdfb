// The language of the window. The command line, files and messages of the libraries are English everywhere.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace boxprobe {

struct WindowLanguage {
  QString code;  ///< as Qt Linguist's files have it: "zh_CN"
  QString name;  ///< in itself
};

/// English first, then every translation this program was built with.
std::vector<WindowLanguage> windowLanguages();

/// The code the user has chosen; "" stands for the system's language, and for anything unreadable in the settings.
QString chosenLanguage();
/// Applies when the window is opened the next time.
void keepLanguage(const QString& code);

/// The first of `wanted` ("de-AT", "zh-Hans-CN", in the order the user prefers them) that there is; "en" if there is
/// none. Traditional Chinese is not taken for Simplified.
QString languageFor(const QStringList& wanted);

/// Loads a language, Qt's own texts with it where they are installed; "" takes the system's. Before any widget is made:
/// what stands in the window stays as it is. Returns the code of the language loaded.
QString loadLanguage(const QString& code);
/// The one that loadLanguage returned last; "en" before.
QString shownLanguage();

}  // namespace boxprobe
