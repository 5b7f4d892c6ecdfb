// See phrase_words.h.
#include "app/gui/widgets/phrase_words.h"

#include <QCoreApplication>

namespace boxprobe {

QString phraseWords(const Phrase& phrase) {
  return QString::fromStdString(phrase.in(
      [](const char* pattern) { return QCoreApplication::translate("boxprobe::Phrase", pattern).toStdString(); }));
}

}  // namespace boxprobe
