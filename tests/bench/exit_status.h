// How a measuring program ends: an error is one line on stderr and the program's exit status. Called by every main
// here.
#pragma once

#include <exception>

#include "app/session/messages.h"
#include "filters/core/base/errors.h"

namespace boxprobe {

template <typename Run>
int exitStatusOf(const Run& run) {
  try {
    run();
    return 0;
  } catch (const Error& error) {
    printError(error.what());
    return error.exitStatus();
  } catch (const std::exception& error) {
    printError(error.what());
    return 1;
  }
}

}  // namespace boxprobe
