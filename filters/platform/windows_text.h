// Text and reasons of errors between Windows and this program, whose text is UTF-8. For the Windows sides alone.
#pragma once

#include <string>

namespace boxprobe {

/// UTF-8 as Windows takes it; what is no UTF-8 becomes replacement characters.
std::wstring wide(const std::string& text);

std::string narrow(const std::wstring& text);

/// The nearest value of errno for GetLastError(), so that callers on every system ask errno for the reason.
void setErrnoFromWindows();

}  // namespace boxprobe
