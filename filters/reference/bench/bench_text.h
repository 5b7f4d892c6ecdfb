// The benchmark's files as text: for programs (bench.json, bench.csv) and for people (report.md). Called by the
// command line, which writes them; knows no file.
#pragma once

#include <string>

#include "filters/reference/bench/bench_result.h"

namespace boxprobe {

/// Ratios with four digits, errors with six: what is beyond that is noise, and would differ from run to run.
std::string benchJson(const BenchResult& result);
/// One line a row of the result, a header first, decimal points, commas between.
std::string benchCsv(const BenchResult& result);
std::string benchReport(const BenchResult& result);

/// Of report.md: what `auto` saves against single techniques, and the rows it chooses by as C++.
std::string benchAutomaticText(const BenchResult& result);
std::string benchMeasuredRows(const BenchResult& result);

/// As printf writes it, up to 511 characters.
__attribute__((format(printf, 1, 2))) std::string formatted(const char* format, ...);

}  // namespace boxprobe
