#pragma once
#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "core/base/types.h"
#include "tests/support/arm_tables.h"

namespace underact::bench {

/// An arm, and poses that it reaches: X_WT[i] is that of q[i]. near: within 0.1 rad of q; far: anywhere.
struct Cases {
  chain::test::Arm arm;
  chain::Chain chain;
  std::vector<std::vector<double>> q, near, far;
  std::vector<Pose> X_WT;
};

/// A line of the table. What was not measured is not printed.
struct Line {
  std::string arm, task, by;
  double median_ns = -1.0;
  double success = -1.0;  // share of the poses: every answer within kReached_m and kReached_rad
  double worst_m = -1.0;  // of the answers that succeeded
  double worst_rad = -1.0;
  std::string note = {};
};

using Lines = std::vector<Line>;

inline constexpr double kReached_m = 1e-6, kReached_rad = 1e-6;
inline constexpr int kRestarts = 20;

/// What one call over all cases takes, ns each: the median of 15 rounds.
template <class Call>
double medianOf(std::size_t cases, const Call& call) {
  std::vector<double> rounds;
  for (int round = 0; round < 15; ++round) {
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < cases; ++i) call(i);
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
    rounds.push_back(took.count() / static_cast<double>(cases));
  }
  std::nth_element(rounds.begin(), rounds.begin() + 7, rounds.end());
  return rounds[7];
}

/// Counts answers against the pose that was asked for, by our own forward kinematics.
struct Score {
  int asked = 0, reached = 0;
  double worst_m = 0.0, worst_rad = 0.0;
  void add(const Pose& got, const Pose& wanted);
  void into(Line& line) const;
};

// One function for each party; a new one is a new file, a line here and a line in main.cpp.
Lines ours(const Cases& cases);
Lines straightLine(const Cases& cases);
Lines orocosKdl(const Cases& cases);
Lines eaik(const Cases& cases);  // a Python module, asked through eaik_bench.py

}  // namespace underact::bench
