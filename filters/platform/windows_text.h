// Text, files and reasons of errors between Windows and this program, whose text is UTF-8. For the Windows sides alone.
#pragma once

#include <string>

namespace boxprobe {

/// UTF-8 as Windows takes it; what is no UTF-8 becomes replacement characters.
std::wstring wide(const std::string& text);

std::string narrow(const std::wstring& text);

/// A file for the C library's functions, binary, not inherited; -1: errno says why not. Unlike its own files, others
/// may rename and remove it meanwhile, as on other systems. `access`, `creation`: CreateFileW's; `flags`:
/// _O_RDONLY or _O_WRONLY.
int openShared(const std::string& path, unsigned long access, unsigned long creation, int flags);

/// The nearest value of errno for GetLastError(), so that callers on every system ask errno for the reason.
void setErrnoFromWindows();

}  // namespace boxprobe
