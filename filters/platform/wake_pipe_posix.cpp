// See wake_pipe.h.
#include <fcntl.h>
#include <unistd.h>

#include "filters/platform/wake_pipe.h"

namespace boxprobe {

WakePipe::WakePipe() {
#ifdef __APPLE__
  open_ = ::pipe(ends_) == 0;
  for (const int end : ends_) {
    if (!open_) break;
    ::fcntl(end, F_SETFD, FD_CLOEXEC);
    ::fcntl(end, F_SETFL, O_NONBLOCK);
  }
#else
  open_ = ::pipe2(ends_, O_CLOEXEC | O_NONBLOCK) == 0;
#endif
}

WakePipe::~WakePipe() {
  if (!open_) return;
  ::close(ends_[0]);
  ::close(ends_[1]);
}

}  // namespace boxprobe
