// See ending_signals.h. What runs in a handler uses functions that POSIX names async-signal-safe alone.
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include "filters/platform/ending_signals.h"

namespace boxprobe {

namespace {

constexpr int kEndingSignals[] = {SIGINT, SIGTERM, SIGHUP};

// A signal handler can reach nothing but globals.
EndingHandlers endingHandlers = {};
struct sigaction handlersBefore[3], alarmBefore;

void signalArrives(int number) {
  endingHandlers.arrived(number);
}

void timeIsOver(int) {
  endingHandlers.late();
}

#ifdef __APPLE__
void makeTimer() {}

void removeTimer() {
  const itimerval never = {};
  setitimer(ITIMER_REAL, &never, nullptr);
}
#else
timer_t stopTimer;
bool haveTimer = false;

void makeTimer() {
  sigevent event = {};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGALRM;
  haveTimer = timer_create(CLOCK_MONOTONIC, &event, &stopTimer) == 0;
}

void removeTimer() {
  if (haveTimer) timer_delete(stopTimer);
  haveTimer = false;
}
#endif

void take(int number, void (*handler)(int), struct sigaction* before) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;  // reads and writes under way are not cut short
  sigaction(number, &action, before);
  if (number == SIGHUP && before->sa_handler == SIG_IGN) sigaction(number, before, nullptr);
}

}  // namespace

void takeEndingSignals(const EndingHandlers& handlers) {
  endingHandlers = handlers;
  makeTimer();
  take(SIGALRM, timeIsOver, &alarmBefore);
  for (int i = 0; i < 3; ++i) take(kEndingSignals[i], signalArrives, &handlersBefore[i]);
}

void giveBackEndingSignals() {
  for (int i = 0; i < 3; ++i) sigaction(kEndingSignals[i], &handlersBefore[i], nullptr);
  removeTimer();
  sigaction(SIGALRM, &alarmBefore, nullptr);
}

void callLateIn(long milliseconds) noexcept {
#ifdef __APPLE__
  itimerval when = {};
  when.it_value.tv_sec = milliseconds / 1000;
  when.it_value.tv_usec = static_cast<suseconds_t>(milliseconds % 1000 * 1000);
  setitimer(ITIMER_REAL, &when, nullptr);
#else
  itimerspec when = {};
  when.it_value.tv_sec = milliseconds / 1000;
  when.it_value.tv_nsec = milliseconds % 1000 * 1000000;
  if (haveTimer) timer_settime(stopTimer, 0, &when, nullptr);
#endif
}

bool writeAll(int descriptor, const char* bytes, std::size_t count) noexcept {
  while (count > 0) {
    const ssize_t written = ::write(descriptor, bytes, count);
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

bool writeFileNow(const char* path, const char* bytes, std::size_t count) noexcept {
  const int file = ::open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return false;
  const bool written = writeAll(file, bytes, count);
  ::close(file);
  return written;
}

void endBySignal(int number) noexcept {
  signal(number, SIG_DFL);
  sigset_t one;
  sigemptyset(&one);
  sigaddset(&one, number);
  pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
  raise(number);
  _exit(128 + number);
}

void ignoreWriteSignals() {
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
}

}  // namespace boxprobe
