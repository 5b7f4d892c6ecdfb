// Levenberg and Marquardt's method: the constants for which a sum of squares is least. Derivatives by differences, so
// the function may be anything. Knows nothing of what is fitted.
#pragma once

#include <functional>
#include <vector>

namespace boxprobe::bench {

using Residuals = std::function<std::vector<double>(const std::vector<double>& constants)>;

/// Improves `constants` for at most `rounds` rounds; the sum of squares reached.
double leastSquares(const Residuals& residuals, std::vector<double>& constants, int rounds);

}  // namespace boxprobe::bench
