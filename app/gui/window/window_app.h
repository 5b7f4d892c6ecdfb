// The program with a window: what `boxprobe [SCENE]` runs. Called by main, which has made sure of a display: Qt would
// abort the process without one. Everything of Qt is in this folder.
#pragma once

#include <string>

namespace boxprobe {

struct WindowOptions {
  std::string statsPath;  ///< --stats: written when the window closes; empty: not at all
  std::string lesson;     ///< name of a lesson to open; empty: none
  std::string language;   ///< of lessons; empty: the locale's
};

/// Returns the process's exit status when the window was closed. `scenePath` may be empty. Throws InputError if it
/// cannot be read, WorkError if the statistics cannot be written or the picture could not be drawn.
int runWindow(int& argc, char** argv, const std::string& scenePath, const WindowOptions& options);

/// Warns if no font is installed: all letters would be boxes. Needs a QGuiApplication.
void warnOfNoFonts();

}  // namespace boxprobe
