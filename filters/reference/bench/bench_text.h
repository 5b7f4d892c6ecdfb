// The benchmark's files as text: bench.json and bench.csv for programs, report.md for people.
#pragma once

#include <string>

#include "filters/reference/bench/bench_result.h"

namespace boxprobe {

/// Ratios with four digits, errors with six: further digits are noise.
std::string benchJson(const BenchResult& result);
/// A header, then one line per row; decimal points and commas.
std::string benchCsv(const BenchResult& result);
std::string benchReport(const BenchResult& result);

/// The part of report.md about `auto`: what it saves against single techniques, and its rows as C++.
std::string benchAutomaticText(const BenchResult& result);
std::string benchMeasuredRows(const BenchResult& result);

/// Like printf; at most 511 characters.
__attribute__((format(printf, 1, 2))) std::string formatted(const char* format, ...);

}  // namespace boxprobe
