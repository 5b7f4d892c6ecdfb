// See interrupt.h. What runs in a handler uses functions that POSIX names async-signal-safe alone.
#include "app/session/interrupt.h"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <atomic>

#include "filters/core/base/errors.h"
#include "filters/io/files/temporary_file.h"

namespace boxprobe {

namespace {

constexpr int kEndingSignals[] = {SIGINT, SIGTERM, SIGHUP};
constexpr long kMillisecondsToStop = 700, kMillisecondsToFinish = 5000;

// A signal handler can reach nothing but globals.
volatile sig_atomic_t signalArrived = 0;
std::atomic<bool> stopSeen{false};
volatile sig_atomic_t patient = 0;
timer_t stopTimer;
bool haveTimer = false;
int guards = 0;
volatile sig_atomic_t wakeDescriptor = -1, sayDescriptor = STDERR_FILENO;
struct sigaction handlersBefore[3], alarmBefore;

void endWithin(long milliseconds) {
  itimerspec when = {};
  when.it_value.tv_sec = milliseconds / 1000;
  when.it_value.tv_nsec = milliseconds % 1000 * 1000000;
  if (haveTimer) timer_settime(stopTimer, 0, &when, nullptr);
}

/// Two, so that a handler finds one whole while the other is written.
struct KeptText {
  std::string path, text;
};
KeptText keptTexts[2];
std::atomic<int> keptNow{0};

/// In a handler.
bool writeWhole(int file, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = write(file, bytes, count);
    if (written <= 0) return false;
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

void say(const char* text, std::size_t count) {
  writeWhole(sayDescriptor, text, count);
}

void writeKeptText() {
  const KeptText& kept = keptTexts[keptNow.load()];
  if (kept.text.empty()) return;
  const int file = open(kept.path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0 || !writeWhole(file, kept.text.data(), kept.text.size())) return;
  close(file);
  constexpr char kSaid[] = "unsaved changes are in ";
  say(kSaid, sizeof kSaid - 1);
  say(kept.path.data(), kept.path.size());
  say("\n", 1);
}

[[noreturn]] void endNow(int number) {
  removeTemporaryFiles();
  writeKeptText();
  constexpr char kLine[] = "boxprobe: interrupted: ended in the middle of a step; files that are complete stay\n";
  say(kLine, sizeof kLine - 1);
  signal(number, SIG_DFL);
  sigset_t one;
  sigemptyset(&one);
  sigaddset(&one, number);
  pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
  raise(number);
  _exit(128 + number);
}

void noteSignal(int number) {
  if (signalArrived != 0) endNow(number);
  signalArrived = number;
  const int wake = wakeDescriptor;
  endWithin(patient != 0 ? kMillisecondsToFinish : kMillisecondsToStop);
  const char byte = 0;
  [[maybe_unused]] const ssize_t ignored = wake < 0 ? 0 : write(wake, &byte, 1);
}

void stopWaiting(int) {
  if (signalArrived != 0) endNow(signalArrived);
}

void take(int number, void (*handler)(int), struct sigaction* before) {
  struct sigaction action = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;  // reads and writes under way are not cut short
  sigaction(number, &action, before);
  if (number == SIGHUP && before->sa_handler == SIG_IGN) sigaction(number, before, nullptr);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  if (guards++ > 0) return;
  signalArrived = 0;
  patient = 0;
  stopSeen = false;
  sigevent event = {};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGALRM;
  haveTimer = timer_create(CLOCK_MONOTONIC, &event, &stopTimer) == 0;
  take(SIGALRM, stopWaiting, &alarmBefore);
  for (int i = 0; i < 3; ++i) take(kEndingSignals[i], noteSignal, &handlersBefore[i]);
}

InterruptGuard::InterruptGuard(int wake) : InterruptGuard() {
  wakeBefore_ = wakeDescriptor;
  wakeDescriptor = wake;
}

InterruptGuard::~InterruptGuard() {
  if (wakeBefore_) wakeDescriptor = *wakeBefore_;
  if (--guards > 0) return;
  for (int i = 0; i < 3; ++i) sigaction(kEndingSignals[i], &handlersBefore[i], nullptr);
  if (haveTimer) timer_delete(stopTimer);
  haveTimer = false;
  sigaction(SIGALRM, &alarmBefore, nullptr);
  // Nobody asked since it arrived: it must not be lost.
  if (signalArrived != 0 && !stopSeen) endNow(signalArrived);
}

void InterruptGuard::waitForPartialResults() {
  if (patient != 0) return;
  patient = 1;
  if (signalArrived != 0) endWithin(kMillisecondsToFinish);
}

bool InterruptGuard::interrupted() const {
  if (signalArrived == 0) return false;
  stopSeen = true;
  return true;
}

int InterruptGuard::signalNumber() const {
  return signalArrived;
}

void InterruptGuard::check() const {
  if (interrupted()) throw WorkError("interrupted: stopped before the work was done");
}

void keepForSignals(const std::string& path, const std::string& text) {
  const int other = 1 - keptNow.load();
  keptTexts[other] = {path, text};
  keptNow.store(other);
}

void sayOfSignalsTo(int descriptor) {
  sayDescriptor = descriptor;
}

void answerWriteSignals() {
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);
}

}  // namespace boxprobe
