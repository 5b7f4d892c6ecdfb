// See terminal.h.
#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include "filters/platform/terminal.h"

namespace boxprobe {

// Consoles take escape sequences when asked to, since Windows 10.
bool errorsGoToTerminal() {
  const HANDLE handle = GetStdHandle(STD_ERROR_HANDLE);
  DWORD mode = 0;
  if (GetConsoleMode(handle, &mode) == 0) return false;
  return SetConsoleMode(handle, mode | ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

KeptErrors::KeptErrors() : kept_(_dup(kStandardError)) {}

KeptErrors::~KeptErrors() {
  if (kept_ >= 0) _close(kept_);
}

void KeptErrors::silence() {
  const int null = _open("NUL", _O_WRONLY | _O_NOINHERIT);
  if (kept_ >= 0 && null >= 0) _dup2(null, kStandardError);
  if (null >= 0) _close(null);
}

void KeptErrors::restore() {
  if (kept_ >= 0) _dup2(kept_, kStandardError);
}

}  // namespace boxprobe
