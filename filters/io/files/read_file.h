// A whole file into memory, with one-line errors. Called by every reader in this folder.
#pragma once

#include <cstdint>
#include <string>

namespace boxprobe {

/// Throws InputError naming the file: not there, a folder, not readable, or above `limit` bytes.
std::string readWholeFile(const std::string& path, std::uintmax_t limit = std::uintmax_t(4) << 30);

}  // namespace boxprobe
