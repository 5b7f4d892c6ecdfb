// Variables of the environment that change how the program draws.
#pragma once

namespace boxprobe {

/// Throws InputError for a variable of this program whose value means nothing, which would otherwise pass as not set.
/// Before anything else is done.
void requireMeantEnvironment();

}  // namespace boxprobe
