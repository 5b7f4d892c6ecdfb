// See window_words.h.
#include "app/gui/widgets/window_words.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace boxprobe {

QString windowWords(const QString& sentence) {
  static const QRegularExpression unit("\\? --set models\\.0\\.unit=\\S+"), up(", --set models\\.0\\.upAxis=\\S+"),
      set("[,;]? ?(or )?--set \\S+"), kind(", or use --as interior"), lossy("; --lossy .*$");
  QString text = sentence;
  text.replace(unit, "? " + QCoreApplication::translate("WindowWords", "Choose it under Model > Unit and up axis"));
  text.replace(up, ", " + QCoreApplication::translate("WindowWords", "choose it under Model > Unit and up axis"));
  text.replace(kind, ", " + QCoreApplication::translate("WindowWords", "or choose Model > Treat as > Interior"));
  text.remove(lossy);
  text.remove(set);
  return text;
}

}  // namespace boxprobe
