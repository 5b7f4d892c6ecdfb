// Reads the values of a VTP file's arrays in any encoding.
#pragma once

#include <vector>

#include "filters/vtk/import/vtp_file.h"

namespace boxprobe {

/// Exactly `wanted` values. Throws InputError with the array; nothing is decompressed before its size is known to
/// match.
std::vector<double> vtpValues(const VtpFile& file, const VtpArray& array, std::size_t wanted, const std::string& path);

}  // namespace boxprobe
