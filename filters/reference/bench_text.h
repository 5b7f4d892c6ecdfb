// The benchmark's files as text: for programs (bench.json, bench.csv) and for people (report.md). Called by the
// command line, which writes them; knows no file.
#pragma once

#include <string>

#include "filters/reference/bench_result.h"

namespace boxprobe {

/// Ratios with four digits, errors with six: what is beyond that is noise, and would differ from run to run.
std::string benchJson(const BenchResult& result);
/// One line a row of the result, a header first, decimal points, commas between.
std::string benchCsv(const BenchResult& result);
std::string benchReport(const BenchResult& result);

}  // namespace boxprobe
