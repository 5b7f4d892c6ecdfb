// What a command that ends soon does without: taking apart at its end what the system takes back in one go. Called by
// main and the commands; the window, which stays, does not.
#pragma once

#include <memory>

namespace boxprobe {

/// Keeps `object` alive until the process ends.
void keepToTheEnd(std::shared_ptr<void> object);

/// Ends the process with that status: output that is buffered is written, no further destructor runs. The caller has
/// checked its outputs. Under a sanitizer, which looks for leaks at the end, returns the status instead.
int endQuickly(int status);

}  // namespace boxprobe
