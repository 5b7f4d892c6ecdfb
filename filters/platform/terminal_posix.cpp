// See terminal.h.
#include <fcntl.h>
#include <unistd.h>

#include "filters/platform/terminal.h"

namespace boxprobe {

bool errorsGoToTerminal() {
  return ::isatty(kStandardError) == 1;
}

KeptErrors::KeptErrors() : kept_(::fcntl(kStandardError, F_DUPFD_CLOEXEC, 3)) {}

KeptErrors::~KeptErrors() {
  if (kept_ >= 0) ::close(kept_);
}

void KeptErrors::silence() {
  const int null = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (kept_ >= 0 && null >= 0) ::dup2(null, kStandardError);
  if (null >= 0) ::close(null);
}

void KeptErrors::restore() {
  if (kept_ >= 0) ::dup2(kept_, kStandardError);
}

}  // namespace boxprobe
