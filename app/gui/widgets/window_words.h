// Sentences of the library as the window says them: what they ask of the command line is asked of the window's menus.
// Called wherever such a sentence is shown.
#pragma once

#include <QString>

namespace boxprobe {

/// `sentence` without flags of the command line.
QString windowWords(const QString& sentence);

}  // namespace boxprobe
