#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "core/kinematics/inverse.h"
#include "tests/support/arm_tables.h"
#include "tests/support/random.h"

// Inverse kinematics within the joint limits, of arms with joints to spare: kPoses poses of joints drawn evenly within
// the limits (joints without limits within a turn) by SplitMix64 from kSeed, joint by joint, each answered from all
// joints at 0 as `underact-cli ik` does. Printed: how many of the answers are within the limits, and us for one: median
// and 99th percentile, each pose the least of kTimes.
namespace underact {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr int kPoses = 300, kTimes = 9;

kinematics::SolvedArm armOf(const std::string& name) {
  if (name != "gen3") return kinematics::chooseArm(name).value();
  const chain::test::Arm table = chain::test::gen3();
  arm::Model model;
  model.rows = table.rows;
  model.chain = table.chain();
  model.joints.resize(table.rows.size());
  return kinematics::solvedArm(model);
}

std::vector<Pose> posesOf(const chain::Chain& chain) {
  test::Random random({kSeed});
  std::vector<Pose> poses;
  for (int i = 0; i < kPoses; ++i) {
    std::vector<double> q;
    for (const chain::Joint& joint : chain.joints)
      q.push_back(random.between(std::max(joint.min, -kPi), std::min(joint.max, kPi)));
    poses.push_back(chain::forward(chain, q));
  }
  return poses;
}

void withinLimits(benchmark::State& state, const std::string& name) {
  const kinematics::SolvedArm arm = armOf(name);
  const std::vector<Pose> poses = posesOf(arm.chain());
  std::vector<double> min_us(poses.size(), kInfinity);
  int within = 0;
  for (auto unused : state) {
    for (int round = 0; round < kTimes; ++round) {
      within = 0;
      for (std::size_t i = 0; i < poses.size(); ++i) {
        const auto begin = std::chrono::steady_clock::now();
        const kinematics::Answer answer = kinematics::solve(arm, poses[i], kinematics::Method::Iteration, {});
        const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
        min_us[i] = std::min(min_us[i], took.count());
        within += !answer.found.empty() && answer.found[0].within_limits ? 1 : 0;
      }
    }
  }
  std::sort(min_us.begin(), min_us.end());
  state.counters["within"] = within;
  state.counters["median_us"] = min_us[kPoses / 2];
  state.counters["p99_us"] = min_us[kPoses * 99 / 100];
}

BENCHMARK_CAPTURE(withinLimits, panda, "panda")->Iterations(1);
BENCHMARK_CAPTURE(withinLimits, iiwa7, "iiwa7")->Iterations(1);
BENCHMARK_CAPTURE(withinLimits, gen3, "gen3")->Iterations(1);

}  // namespace
}  // namespace underact
