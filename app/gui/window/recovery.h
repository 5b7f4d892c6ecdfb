// What a process that ended without saving left behind, offered to the user at the next start.
#pragma once

namespace boxprobe {

class MainWindow;

/// Asks about each scene left behind, newest first, until one is recovered: recover it, give it up, or be asked again
/// at the next start. Does nothing where nothing was left.
void offerRecovery(MainWindow& window);

/// After the graphics driver was reset: keeps unsaved changes for the next start and asks whether to start again now.
bool offerRestart(MainWindow& window);

}  // namespace boxprobe
