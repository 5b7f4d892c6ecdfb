#include "filters/io/files/read_budget.h"

#include "filters/core/base/errors.h"
#include "filters/core/base/number_text.h"
#include "filters/core/base/one_line.h"
#include "filters/platform/process.h"

namespace boxprobe {

std::uint64_t& readBudgetBytes() {
  static std::uint64_t most = physicalMemoryBytes() / 6;
  return most;
}

void ReadBudget::count(std::uint64_t bytes, const std::string& place) {
  // Of what is not compressed and named once, nothing grows more: an index of 2 bytes may become a corner of 32.
  constexpr std::uint64_t kGrowth = 16;
  if (readBudgetBytes() == 0) return;
  const std::uint64_t most = readBudgetBytes() + kGrowth * own_;
  if (bytes <= most - counted_) {
    counted_ += bytes;
    return;
  }
  throw InputError(
      oneLine(place + ": comes, with all before it, to more than " + gigabytesText(most) +
              ", the most that the file's " + std::to_string(own_) +
              " bytes may become on this machine; split the file, or let fewer parts share the same data"));
}

}  // namespace boxprobe
