#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/base/types.h"

namespace underact::test {

struct Seed {
  std::uint64_t value;
};

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers with every compiler and library, unlike std's distributions.
class Random {
 public:
  explicit Random(Seed seed) : state_(seed.value) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
  }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11U) * 0x1p-53);
  }
  Vec3 inBox(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = inBox(1.0);
      if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
    }
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }

 private:
  std::uint64_t state_;
};

inline std::vector<Vec3> pointsInBox(double half_m, int count, Seed seed) {
  Random random(seed);
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) points.push_back(random.inBox(half_m));
  return points;
}

/// How many draws a sweep makes: `sampled` in packaging/test, `full` in packaging/soak (UNDERACT_SOAK=1).
inline int sweep(int sampled, int full) {
  const char* soak = std::getenv("UNDERACT_SOAK");
  return soak != nullptr && *soak == '1' ? full : sampled;
}

}  // namespace underact::test
