// See translations.h.
#include "app/gui/translations/translations.h"

#ifdef BOXPROBE_TRANSLATED
#include <QDir>  // for the macro below

// In no namespace: the macro declares a function of the resource compiler's.
static void readCompiled() {
  Q_INIT_RESOURCE(boxprobe_translations);
}
#endif

namespace boxprobe {

void openTranslations() {
#ifdef BOXPROBE_TRANSLATED
  readCompiled();
#endif
}

}  // namespace boxprobe
