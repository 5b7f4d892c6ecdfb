// What a command that ends soon does without: memory in small pages, and taking apart at its end what the system takes
// back in one go. Called by main and the commands; the window, which stays, does neither.
#pragma once

#include <memory>

namespace boxprobe {

/// Has the heap grow in large pages, which are taken from the system a thousand times more seldom, and keeps what is
/// freed. To be called before threads are started. Does nothing where the C library or the system has no such thing or
/// addresses are limited (ulimit -v).
void useLargePages();

/// Keeps `object` alive until the process ends.
void keepToTheEnd(std::shared_ptr<void> object);

/// Ends the process with that status: output that is buffered is written, no further destructor runs. The caller has
/// checked its outputs. Under a sanitizer, which looks for leaks at the end, returns the status instead.
int endQuickly(int status);

}  // namespace boxprobe
