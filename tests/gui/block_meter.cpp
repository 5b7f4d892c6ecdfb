// See block_meter.h.
#include "tests/gui/block_meter.h"

#include <time.h>

#include <QAbstractEventDispatcher>
#include <QEvent>
#include <QMetaEnum>
#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

namespace boxprobe {

namespace {

constexpr double kLongMilliseconds = 200.0;

/// Of this thread, milliseconds.
double cpuNow() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

std::string kindOf(const QObject* receiver, const QEvent* event) {
  const char* name = QMetaEnum::fromType<QEvent::Type>().valueToKey(event->type());
  return std::string(name != nullptr ? name : "event") + " of " + receiver->metaObject()->className();
}

}  // namespace

BlockMeter::BlockMeter(int& argc, char** argv) : QApplication(argc, argv) {
  // A loop within an event, of a dialog or of progress, looks at what came in: a block ends there.
  const QAbstractEventDispatcher* loop = QAbstractEventDispatcher::instance();
  connect(loop, &QAbstractEventDispatcher::aboutToBlock, this, [this] { looksAtEvents(true); });
  connect(loop, &QAbstractEventDispatcher::awake, this, [this] { looksAtEvents(false); });
}

void BlockMeter::looksAtEvents(bool mayWait) {
  if (depth_ == 0) return;
  if (!waits_) end(kind_);
  waits_ = mayWait;
  begin();
}

void BlockMeter::begin() {
  if (counters_) before_ = counters_();
  cpuBefore_ = cpuNow();
  clock_.start();
}

std::string BlockMeter::work() const {
  if (!counters_) return {};
  const Counters now = counters_();
  if (now.programsCompiled > before_.programsCompiled) return "a shader program compiled";
  if (now.facesCaptured > before_.facesCaptured) return "a face captured";
  if (now.levelsFiltered > before_.levelsFiltered || now.levelsMadeLater > before_.levelsMadeLater)
    return "a level filtered";
  if (now.renders > before_.renders) return "a picture drawn";
  return {};
}

void BlockMeter::end(const std::string& kind) {
  const double milliseconds = 1e-6 * static_cast<double>(clock_.nsecsElapsed());
  const std::string did = work();
  Kind& row = kinds_[did.empty() ? kind : did];
  ++row.blocks;
  if (milliseconds > kLongMilliseconds) ++row.long_;
  if (milliseconds <= row.longest) return;
  row.longest = milliseconds;
  row.cpu = cpuNow() - cpuBefore_;
  row.what = did.empty() ? label_ : kind + ", " + label_;
}

bool BlockMeter::notify(QObject* receiver, QEvent* event) {
  if (waits_) {
    waits_ = false;
    kind_ = kindOf(receiver, event);
    begin();
  }
  if (depth_ > 0) {
    ++depth_;
    const bool done = QApplication::notify(receiver, event);
    --depth_;
    return done;
  }
  kind_ = kindOf(receiver, event);
  const std::string kind = kind_;
  ++depth_;
  begin();
  const bool done = QApplication::notify(receiver, event);
  --depth_;
  waits_ = false;
  end(kind);
  return done;
}

void BlockMeter::during(const std::string& kind, const std::function<void()>& call) {
  if (depth_ > 0) return call();
  kind_ = kind;
  ++depth_;
  begin();
  call();
  --depth_;
  waits_ = false;
  end(kind);
}

std::string BlockMeter::table() const {
  std::vector<std::pair<std::string, Kind>> rows(kinds_.begin(), kinds_.end());
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.second.longest > b.second.longest; });
  std::string text = "longest ms  of it CPU  blocks  > 0.2 s  kind (what the longest one was)\n";
  constexpr std::size_t kRows = 20;
  for (std::size_t i = 0; i < std::min(rows.size(), kRows); ++i) {
    const auto& [kind, row] = rows[i];
    char numbers[64];
    std::snprintf(numbers, sizeof numbers, "%10.0f %10.0f %7zu %8zu  ", row.longest, row.cpu, row.blocks, row.long_);
    text += numbers + kind + " (" + row.what + ")\n";
  }
  return text;
}

}  // namespace boxprobe
