// See interrupt.h. What runs in a handler calls only what may be called there (filters/platform/ending_signals.h).
#include "app/session/interrupt.h"

#include <atomic>

#include "filters/core/base/errors.h"
#include "filters/io/files/temporary_file.h"
#include "filters/platform/ending_signals.h"
#include "filters/platform/terminal.h"

namespace boxprobe {

namespace {

constexpr long kMillisecondsToStop = 700, kMillisecondsToFinish = 5000;

// A signal handler can reach nothing but globals.
std::atomic<int> signalArrived{0};
std::atomic<bool> stopSeen{false}, patient{false};
int guards = 0;
std::atomic<int> wakeDescriptor{-1}, sayDescriptor{kStandardError};

/// Two, so that a handler finds one whole while the other is written.
struct KeptText {
  std::string path, text;
};
KeptText keptTexts[2];
std::atomic<int> keptNow{0};

void say(const char* text, std::size_t count) {
  writeAll(sayDescriptor, text, count);
}

void writeKeptText() {
  const KeptText& kept = keptTexts[keptNow.load()];
  if (kept.text.empty() || !writeFileNow(kept.path.c_str(), kept.text.data(), kept.text.size())) return;
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
  endBySignal(number);
}

void noteSignal(int number) {
  if (signalArrived != 0) endNow(number);
  signalArrived = number;
  const int wake = wakeDescriptor;
  callLateIn(patient ? kMillisecondsToFinish : kMillisecondsToStop);
  const char byte = 0;
  if (wake >= 0) writeAll(wake, &byte, 1);
}

void stopWaiting() {
  if (signalArrived != 0) endNow(signalArrived);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  if (guards++ > 0) return;
  signalArrived = 0;
  patient = false;
  stopSeen = false;
  takeEndingSignals({noteSignal, stopWaiting});
}

InterruptGuard::InterruptGuard(int wake) : InterruptGuard() {
  wakeBefore_ = wakeDescriptor;
  wakeDescriptor = wake;
}

InterruptGuard::~InterruptGuard() {
  if (wakeBefore_) wakeDescriptor = *wakeBefore_;
  if (--guards > 0) return;
  giveBackEndingSignals();
  // Nobody asked since it arrived: it must not be lost.
  if (signalArrived != 0 && !stopSeen) endNow(signalArrived);
}

void InterruptGuard::waitForPartialResults() {
  if (patient) return;
  patient = true;
  if (signalArrived != 0) callLateIn(kMillisecondsToFinish);
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
  ignoreWriteSignals();
}

}  // namespace boxprobe
