// The window's translations, compiled into the program.
#pragma once

namespace boxprobe {

/// Makes them readable as ":/translations/boxprobe_de.qm" and so on. None are where the build found no lrelease.
void openTranslations();

}  // namespace boxprobe
