// What files that this program writes say of their writer.
#pragma once

namespace boxprobe {

constexpr const char* kProgramName = "Boxprobe " BOXPROBE_VERSION;

}  // namespace boxprobe
