// The values of a VTP file's arrays, whatever they are stored as. Called by the VTP reader. Knows no VTK.
#pragma once

#include <vector>

#include "filters/vtk/import/vtp_file.h"

namespace boxprobe {

/// `wanted` values, not one more or less. Throws InputError naming the array; nothing is decompressed before its size
/// is known to be the wanted one.
std::vector<double> vtpValues(const VtpFile& file, const VtpArray& array, std::size_t wanted, const std::string& path);

}  // namespace boxprobe
