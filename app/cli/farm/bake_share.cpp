#include "app/cli/farm/bake_share.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <numeric>
#include <string_view>

#include "filters/core/base/errors.h"

namespace boxprobe {

namespace {

std::optional<int> wholeNumber(std::string_view text) {
  int value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || result.ec != std::errc() || result.ptr != text.data() + text.size()) return {};
  return value;
}

std::optional<int> environmentNumber(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? std::nullopt : wholeNumber(text);
}

/// Of variables that count from 0.
std::optional<BakeShare> ranked(const char* rankName, const char* sizeName) {
  const auto rank = environmentNumber(rankName), size = environmentNumber(sizeName);
  if (!rank || !size || *rank < 0 || *rank >= *size) return {};
  return BakeShare{*rank + 1, *size};
}

/// SLURM_ARRAY_TASK_COUNT tasks from _MIN on, _STEP apart.
std::optional<BakeShare> slurmArrayShare() {
  const auto task = environmentNumber("SLURM_ARRAY_TASK_ID"), count = environmentNumber("SLURM_ARRAY_TASK_COUNT");
  if (!task || !count) return {};
  const int first = environmentNumber("SLURM_ARRAY_TASK_MIN").value_or(0);
  const int step = std::max(environmentNumber("SLURM_ARRAY_TASK_STEP").value_or(1), 1);
  const int index = (*task - first) / step + 1;
  // A task sent again alone, or a list with gaps, has a place that says nothing about the others.
  if (index < 1 || index > *count || (*task - first) % step != 0) {
    throw InputError("--shard auto: task " + std::to_string(*task) + " of the array job is not one of " +
                     std::to_string(*count) + " in a row; submit it as --array=1-" + std::to_string(*count) +
                     ", or say --shard I/N");
  }
  return BakeShare{index, *count};
}

double texelsOf(const Probe& probe) {
  return 6.0 * probe.faceSize * probe.faceSize;
}

}  // namespace

double bakeSeconds(const Probe& probe) {
  constexpr double kSixFaces = 0.2, kTexel = 4e-7;  // at one sample a pixel
  return probe.bounces * (kSixFaces + kTexel * probe.samplesPerPixel * texelsOf(probe));
}

double bakeBytes(const Probe& probe) {
  constexpr double kTexel = 10.0;
  return kTexel * texelsOf(probe);
}

std::optional<BakeShare> mpiShare() {
  if (const auto share = ranked("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE")) return share;
  return ranked("PMI_RANK", "PMI_SIZE");
}

BakeShare parseBakeShare(const std::string& text) {
  if (text == "auto") {
    if (const auto share = slurmArrayShare()) return *share;
    if (const auto share = mpiShare()) return *share;
    if (const auto share = ranked("SLURM_PROCID", "SLURM_NTASKS")) return *share;
    throw InputError(
        "--shard auto: this is neither a task of a Slurm array job nor started by mpiexec or srun; say --shard I/N");
  }
  const std::size_t slash = text.find('/');
  const auto index = wholeNumber(std::string_view(text).substr(0, slash));
  const auto count = slash == std::string::npos ? std::nullopt : wholeNumber(std::string_view(text).substr(slash + 1));
  if (!index || !count || *count < 1 || *index < 1 || *index > *count) {
    throw InputError("--shard " + text + ": expected I/N with I from 1 to N, as in 3/8, or auto");
  }
  return {*index, *count};
}

std::vector<std::string> probesOfShare(const std::vector<Probe>& probes, const BakeShare& share) {
  std::vector<double> seconds;
  for (const Probe& probe : probes) seconds.push_back(bakeSeconds(probe));
  std::vector<std::size_t> order(probes.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return seconds[a] > seconds[b]; });

  // Shares beyond the number of probes get none.
  const std::size_t busy = std::min(static_cast<std::size_t>(share.count), std::max(probes.size(), std::size_t(1)));
  std::vector<double> load(busy, 0.0);
  std::vector<bool> ours(probes.size(), false);
  for (const std::size_t index : order) {
    const auto least = std::min_element(load.begin(), load.end());
    *least += seconds[index];
    ours[index] = least - load.begin() == share.index - 1;
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    if (ours[i]) names.push_back(probes[i].name);
  }
  return names;
}

}  // namespace boxprobe
