// See interrupt.h.
#include "app/session/interrupt.h"

#include <csignal>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {
// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t signalArrived = 0;

void noteSignal(int) {
  signalArrived = 1;
}
}  // namespace

struct InterruptGuard::Handlers {
  struct sigaction interrupt {};
  struct sigaction terminate {};
};

InterruptGuard::InterruptGuard() : previous_(new Handlers) {
  signalArrived = 0;
  struct sigaction action {};
  action.sa_handler = noteSignal;
  sigemptyset(&action.sa_mask);
  // SA_RESETHAND: the second signal is not held back. SA_RESTART: reads and writes under way are not cut short.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, &previous_->interrupt);
  sigaction(SIGTERM, &action, &previous_->terminate);
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &previous_->interrupt, nullptr);
  sigaction(SIGTERM, &previous_->terminate, nullptr);
  delete previous_;
}

bool InterruptGuard::interrupted() const {
  return signalArrived != 0;
}

void InterruptGuard::check() const {
  if (interrupted()) throw WorkError("interrupted: stopped before the work was done");
}

}  // namespace boxprobe
