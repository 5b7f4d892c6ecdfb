// Phrases of the library in the window's language. lupdate finds their patterns in the library's source.
#pragma once

#include <QString>

#include "filters/core/base/phrase.h"

namespace boxprobe {

QString phraseWords(const Phrase& phrase);

}  // namespace boxprobe
