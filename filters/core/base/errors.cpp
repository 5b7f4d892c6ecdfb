#include "filters/core/base/errors.h"

namespace boxprobe {

std::string messageOf(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return kOutOfMemory;
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  if (system != nullptr &&
      system->code() == std::errc::resource_unavailable_try_again) {  // what starting a thread says
    return "the system gives no more threads or memory; close other programs, or raise the limits (ulimit -u, -v)";
  }
  return error.what();
}

}  // namespace boxprobe
