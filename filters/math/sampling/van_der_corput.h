// Evenly spread numbers.
#pragma once

namespace boxprobe {

/// Van der Corput's sequence in a prime base, in [0, 1): low discrepancy at any length and, with different bases, in
/// any dimension.
inline double vanDerCorput(int index, int base) {
  double value = 0.0, share = 1.0;
  for (; index > 0; index /= base) {
    share /= base;
    value += share * (index % base);
  }
  return value;
}

}  // namespace boxprobe
