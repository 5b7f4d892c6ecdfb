// The menu View > Language.
#pragma once

class QMainWindow;
class QMenu;

namespace boxprobe {

/// Adds it to `view`. What is chosen is kept for the next start, which the window's status bar says.
void addLanguageMenu(QMenu* view, QMainWindow* window);

}  // namespace boxprobe
