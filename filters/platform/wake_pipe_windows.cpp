// See wake_pipe.h. Qt watches sockets there, no pipes.
#include "filters/platform/wake_pipe.h"

namespace boxprobe {

WakePipe::WakePipe() : open_(true) {}

WakePipe::~WakePipe() = default;

}  // namespace boxprobe
