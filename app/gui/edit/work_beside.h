// Work that somebody waits for, in a thread of its own while the window goes on drawing: a file that is opened, a model
// that is fitted again. Called where the next line needs the result; long work that nobody waits for is
// background_work's.
#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace boxprobe {

/// Told how far the work is, 0 to 1; false: it was cancelled.
using BesideProgress = std::function<bool(double)>;

/// Runs `work` in a thread, which must not touch the window, and returns when it has ended; throws what it throws.
/// Input waits meanwhile; after half a second a dialog shows `title` and, if `stoppable`, offers to cancel. `work` must
/// then soon return or throw; so it must when the program is to end.
void workBeside(QWidget* window, const QString& title, bool stoppable,
                const std::function<void(const BesideProgress&)>& work);

/// Is there such work? Nobody begins other such work then, or replaces the scene.
bool workBesideRuns();

}  // namespace boxprobe
