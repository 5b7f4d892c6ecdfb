// How long the window's event loop is busy without looking at what came in meanwhile: each event, timed, by its kind.
// The application of all window tests; the monkey prints its table.
#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <functional>
#include <map>
#include <string>

#include "filters/core/base/counters.h"

namespace boxprobe {

class BlockMeter : public QApplication {
 public:
  BlockMeter(int& argc, char** argv);

  /// What was counted so far: says which work a block was. Without it, blocks are told by their events alone.
  void setCounters(std::function<Counters()> counters) { counters_ = std::move(counters); }
  /// What goes on, for the longest block's row.
  void setLabel(const std::string& label) { label_ = label; }
  /// For what a test calls in place of an event that would have come.
  void during(const std::string& kind, const std::function<void()>& call);
  void forget() { kinds_.clear(); }
  /// One row a kind: the longest block in milliseconds, of them the processor's for this thread (the rest is waiting,
  /// for other threads or programs), blocks in all, those over 0.2 s, and what the longest was. Longest first.
  std::string table() const;

  bool notify(QObject* receiver, QEvent* event) override;

 private:
  struct Kind {
    std::size_t blocks = 0, long_ = 0;
    double longest = 0.0, cpu = 0.0;  ///< milliseconds
    std::string what;
  };
  void begin();
  void end(const std::string& kind);
  void looksAtEvents(bool mayWait);
  std::string work() const;

  std::map<std::string, Kind> kinds_;
  std::function<Counters()> counters_;
  Counters before_;
  std::string label_;
  std::string kind_;  ///< of the event under way
  QElapsedTimer clock_;
  double cpuBefore_ = 0.0;
  int depth_ = 0;
  bool waits_ = false;  ///< a nested event loop waits for what comes
};

}  // namespace boxprobe
