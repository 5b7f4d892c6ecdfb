// See stress_run.h.
#include "filters/stress/stress_run.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <mutex>

namespace boxprobe::stress {

namespace {

// Large enough to hide a task's overhead, small enough to react to Ctrl-C at once.
constexpr std::uint64_t kChunk = 2048;

struct Chunk {
  std::size_t cell;
  std::uint64_t first, end;
};

}  // namespace

StressInput StressCell::worstInput(std::uint64_t seed) const {
  return makeInput(*inputs, subject->id, seed, tally.worstIndex, subject->parameters);
}

bool StressCell::broken() const {
  if (subject->counterpart != nullptr) return false;
  const bool held = inputs->held == Held::All || inputs->held == Held::ByReach;
  const ErrorHistogram& hit = tally.errors[kBoxSizes];
  const bool tooMany =
      subject->mostBoxSizes > 0.0 && held && hit.measured() && hit.quantile(0.9999) > subject->mostBoxSizes;
  return tally.broken > 0 || tooMany;
}

std::vector<StressCell> stressCells(const StressPlan& plan) {
  std::vector<StressCell> cells;
  for (const StressClass* inputs : plan.classes) {
    for (const StressSubject* subject : plan.subjects) cells.push_back({inputs, subject, {}});
  }
  return cells;
}

std::uint64_t inputsOfCell(const StressPlan& plan, std::size_t cell) {
  const std::uint64_t cells = plan.classes.size() * plan.subjects.size();
  return plan.count / cells + (cell < plan.count % cells ? 1 : 0);
}

std::vector<StressCell> runStress(const StressPlan& plan, const std::function<bool(double)>& progress) {
  std::vector<StressCell> cells = stressCells(plan);
  std::vector<Chunk> chunks;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const std::uint64_t count = inputsOfCell(plan, cell);
    for (std::uint64_t first = 0; first < count; first += kChunk) {
      chunks.push_back({cell, first, std::min(first + kChunk, count)});
    }
  }
  std::mutex mutex;  // of the cells and of `progress`
  std::atomic<bool> stopped{false};
  std::size_t done = 0;
  tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t i) {
    if (stopped) return;
    const Chunk& chunk = chunks[i];
    const StressCell& cell = cells[chunk.cell];
    StressTally tally;
    for (std::uint64_t index = chunk.first; index < chunk.end; ++index) {
      const StressInput in = makeInput(*cell.inputs, cell.subject->id, plan.seed, index, cell.subject->parameters);
      tally.add(cell.subject->run(in, *cell.inputs, nullptr), index);
    }
    const std::scoped_lock lock(mutex);
    cells[chunk.cell].tally.merge(tally);
    ++done;
    if (!progress(static_cast<double>(done) / static_cast<double>(chunks.size()))) stopped = true;
  });
  if (stopped) cells.clear();
  return cells;
}

}  // namespace boxprobe::stress
