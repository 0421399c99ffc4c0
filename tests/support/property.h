#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "tests/support/random.h"

namespace underact::test {

inline std::vector<Vec3> pointsInBox(double half_m, int count, Seed seed) {
  Random random(seed);
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) points.push_back(random.inBox(half_m));
  return points;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kIsWatched = true;  // every access is checked, which takes five to ten times as long
#else
inline constexpr bool kIsWatched = false;
#endif

/// Whether all there is is to be tried, as in packaging/soak (UNDERACT_SOAK=1), in place of a sample.
inline bool isSoak() {
  const char* soak = std::getenv("UNDERACT_SOAK");
  return soak != nullptr && *soak == '1';
}

/// How many draws a sweep makes: `sampled` in packaging/test, `full` in packaging/soak (UNDERACT_SOAK=1).
inline int sweep(int sampled, int full) {
  return isSoak() ? full : sampled;
}

/// The same for draws that are dear: a tenth of the sample, one at least, under a sanitizer.
inline int dearSweep(int sampled, int full) {
  return sweep(kIsWatched ? std::max(sampled / 10, 1) : sampled, full);
}

}  // namespace underact::test
