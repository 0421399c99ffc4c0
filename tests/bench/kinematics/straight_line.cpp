#include <benchmark/benchmark.h>

#include <algorithm>

#include "core/arm/branches.h"
#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "core/arm/model.h"
#include "tests/bench/kinematics/table.h"

namespace underact::bench {
namespace {

arm::JointAngles sixOf(const std::vector<double>& q) {
  arm::JointAngles q_rad{};
  std::copy_n(q.begin(), std::min(q.size(), q_rad.size()), q_rad.begin());
  return q_rad;
}

}  // namespace

/// The Omni's own code; nothing for another arm.
Lines straightLine(const Cases& cases) {
  const arm::Model& model = *arm::findModel("omni-thesis");
  const arm::Geometry geometry = *arm::omniGeometry(model);
  const arm::JointLimits limits = arm::limitsOf(model);
  const bool same = (arm::tipPose(geometry, sixOf(cases.q[0])).matrix() - cases.X_WT[0].matrix()).isZero(1e-12);
  if (!same) return {};
  std::vector<arm::JointAngles> q_rad;
  for (const std::vector<double>& one : cases.q) q_rad.push_back(sixOf(one));
  const std::size_t count = q_rad.size();

  Line place{cases.arm.name, "forward, place alone", "straight line"},
      forward{cases.arm.name, "forward", "straight line"},
      both{cases.arm.name, "forward and Jacobian", "straight line"},
      gains{cases.arm.name, "gains and axes of J_p", "straight line"},
      all{cases.arm.name, "inverse, all branches", "straight line"};
  place.median_ns =
      medianOf(count, [&](std::size_t i) { benchmark::DoNotOptimize(arm::tipPosition(geometry, q_rad[i])); });
  forward.median_ns =
      medianOf(count, [&](std::size_t i) { benchmark::DoNotOptimize(arm::tipPose(geometry, q_rad[i])); });
  both.median_ns =
      medianOf(count, [&](std::size_t i) { benchmark::DoNotOptimize(arm::kinematics(geometry, q_rad[i])); });
  gains.median_ns =
      medianOf(count, [&](std::size_t i) { benchmark::DoNotOptimize(arm::dexterity(geometry, q_rad[i])); });
  all.median_ns =
      medianOf(count, [&](std::size_t i) { benchmark::DoNotOptimize(arm::solveAll(geometry, limits, cases.X_WT[i])); });
  Score score;
  std::size_t answers = 0;
  for (const Pose& X_WT : cases.X_WT) {
    const arm::Solutions found = arm::solveAll(geometry, limits, X_WT);
    for (const arm::Solution& one : found) score.add(arm::tipPose(geometry, one.q_rad), X_WT);
    answers += found.count;
  }
  score.into(all);
  all.note = std::to_string(answers) + " answers, with limits and singularities";
  return {place, forward, both, gains, all};
}

}  // namespace underact::bench
