#include <cstdio>

#include "core/arm/model.h"
#include "core/chain/kinematics.h"
#include "tests/bench/kinematics/table.h"
#include "tests/support/random.h"

// underact-kinematics-bench: our chain kinematics beside those of Orocos KDL and EAIK, over the same poses. Prints one
// table, asserts nothing.
namespace underact::bench {

void Score::add(const Pose& got, const Pose& wanted) {
  const double off_m = (got.translation() - wanted.translation()).norm();
  const double off_rad = Eigen::AngleAxisd(got.linear().transpose() * wanted.linear()).angle();
  ++asked;
  if (!(off_m <= kReached_m && off_rad <= kReached_rad)) return;
  ++reached;
  worst_m = std::max(worst_m, off_m);
  worst_rad = std::max(worst_rad, off_rad);
}

void Score::into(Line& line) const {
  line.success = static_cast<double>(reached) / asked;
  line.worst_m = worst_m;
  line.worst_rad = worst_rad;
}

namespace {

std::vector<double> anyAngles(test::Random& random, std::size_t joints) {
  std::vector<double> q;
  for (std::size_t joint = 0; joint < joints; ++joint) q.push_back(random.between(-kPi, kPi));
  return q;
}

/// A shipped arm.
chain::test::Arm shipped(const char* name) {
  const arm::Model& model = *arm::findModel(name);
  return {model.name, model.rows, model.X_WB, model.X_NT};
}

Cases casesOf(const chain::test::Arm& arm, std::uint64_t seed) {
  Cases cases{arm, arm.chain(), {}, {}, {}, {}};
  test::Random random({seed});
  for (int i = 0; i < 1000; ++i) {
    cases.q.push_back(anyAngles(random, arm.rows.size()));
    cases.near.push_back(cases.q.back());
    for (double& one : cases.near.back()) one += random.between(-0.1, 0.1);
    cases.far.push_back(anyAngles(random, arm.rows.size()));
    cases.X_WT.push_back(chain::forward(cases.chain, cases.q.back()));
  }
  return cases;
}

void print(const Lines& lines) {
  const auto cell = [](const char* format, double value) {
    if (value < 0.0) {
      std::printf(" %10s", "-");
    } else {
      std::printf(format, value);
    }
  };
  for (const Line& line : lines) {
    std::printf("%-12s %-34s %-12s", line.arm.c_str(), line.task.c_str(), line.by.c_str());
    cell(" %10.0f", line.median_ns);
    cell(" %9.1f%%", 100.0 * line.success);
    cell(" %10.1e", line.worst_m);
    cell(" %10.1e", line.worst_rad);
    std::printf("  %s\n", line.note.c_str());
  }
}

}  // namespace
}  // namespace underact::bench

int main() {
  using namespace underact;
  std::printf("%-12s %-34s %-12s %10s %10s %10s %10s\n", "arm", "task", "by", "median ns", "success", "worst m",
              "worst rad");
  std::uint64_t seed = 1;
  for (const chain::test::Arm& arm :
       {chain::test::omni(), chain::test::puma(), bench::shipped("ur5e"), bench::shipped("panda")}) {
    const bench::Cases cases = bench::casesOf(arm, seed++);
    for (const auto& party : {bench::straightLine, bench::ours, bench::orocosKdl, bench::eaik})
      bench::print(party(cases));
  }
  return 0;
}
