// Writes the table of brdf_table.h into a file; a program of the build.
#include <cmath>
#include <cstdio>

#include "filters/math/sampling/brdf_integral.h"
#include "filters/math/sampling/brdf_table.h"

int main(int argc, char** argv) {
  std::FILE* file = argc == 2 ? std::fopen(argv[1], "w") : nullptr;
  if (file == nullptr) {
    std::fprintf(stderr, "usage: write_brdf_table FILE (that can be written)\n");
    return 2;
  }
  constexpr int kLast = boxprobe::kBrdfTableSize - 1;
  for (int row = 0; row <= kLast; ++row) {
    for (int column = 0; column <= kLast; ++column) {
      // Columns are even in the root of N.V (splitSumPlace). At the edge itself the limit is evaluated just beside it.
      const double across = static_cast<double>(column) / kLast;
      const glm::dvec2 e =
          boxprobe::integrateBrdf(std::fmax(across * across, 1.0e-6), static_cast<double>(row) / kLast);
      std::fprintf(file, "%ld,%ld,%s", std::lround(65535.0 * e.x), std::lround(65535.0 * e.y),
                   column % 8 == 7 ? "\n" : "");
    }
  }
  return std::fclose(file) == 0 ? 0 : 1;
}
