// Random numbers for stress inputs. Each input has a generator seeded by its identity, so that it does not depend on
// threads or other inputs. splitmix64 (Steele, Lea, Flood 2014).
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string_view>

namespace boxprobe::stress {

class StressRandom {
 public:
  explicit StressRandom(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  /// [0, 1)
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Uniform in the logarithm; both ends positive.
  double logBetween(double low, double high) { return low * std::pow(high / low, unit()); }
  int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
  bool chance(double p) { return unit() < p; }
  double sign() { return (next() & 1) != 0 ? 1.0 : -1.0; }
  /// Uniform over the sphere.
  glm::dvec3 direction() {
    const double z = between(-1.0, 1.0), phi = between(0.0, 6.283185307179586), r = std::sqrt(1.0 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }

 private:
  std::uint64_t state_;
};

/// FNV-1a of ids, not indices: a new row leaves the inputs of others unchanged.
constexpr std::uint64_t idHash(std::string_view id) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : id) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

}  // namespace boxprobe::stress
