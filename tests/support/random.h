#pragma once
#include <cstddef>
#include <cstdint>

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

}  // namespace underact::test
