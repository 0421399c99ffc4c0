#pragma once
#include <gtest/gtest.h>

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

/// How many draws a sweep makes: `sampled` in packaging/test, `full` in packaging/soak (UNDERACT_SOAK=1).
inline int sweep(int sampled, int full) {
  const char* soak = std::getenv("UNDERACT_SOAK");
  return soak != nullptr && *soak == '1' ? full : sampled;
}

}  // namespace underact::test
