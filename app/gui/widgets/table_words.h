// The words of the tables below the window (fields, techniques, debug views), which are English for files and commands,
// in the window's language.
#pragma once

#include <QString>
#include <QStringList>
#include <string_view>

namespace boxprobe {

/// A label, unit or help line of a table; as it is where there is no translation.
QString tableWords(std::string_view english);

/// Every text of the tables that translations have.
QStringList tableTexts();

}  // namespace boxprobe
