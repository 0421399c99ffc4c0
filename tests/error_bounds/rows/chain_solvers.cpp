#include <array>

#include "core/arm/model.h"
#include "core/base/norms.h"
#include "core/chain/closed_form.h"
#include "core/chain/numeric_inverse.h"
#include "tests/error_bounds/oracle/chain.h"
#include "tests/error_bounds/rows/draws.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace chain_solvers_rows {

/// One of the shipped arms, as a chain, scaled.
chain::Chain drawShippedArm(Input& input) {
  // In this order, for cases that were found and kept; a further one at the end.
  static constexpr std::array kArms{"abb-irb-120", "omni-thesis", "puma-560", "touch-measured", "woodenhaptics", "kr5"};
  const std::size_t which = input.choice("arm", kArms.size());
  const double factor = input.number("factor", [](Dice& dice) { return dice.one(2) ? 1.0 : dice.scale(); });
  chain::Chain chain = arm::findModel(kArms[which])->chain;
  for (chain::Joint& joint : chain.joints) joint.p_WJ *= factor;
  chain.X_WT_home.translation() *= factor;
  return chain;
}

/// The pose of given joints, often near singular ones; rounded, so that an exact solution need not exist.
struct Asked {
  Pose X_WT;
  std::vector<double> q;
};
Asked drawAsked(Input& input, const chain::Chain& chain) {
  std::vector<double> q;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    q.push_back(input.number("q", [](Dice& dice) {
      return dice.one(3) ? static_cast<double>(dice.below(4)) * (0.5 * kPi) - 0.5 * kPi + 0.5 * dice.closeness()
                         : dice.between(-kPi, kPi);
    }));
  }
  return {chain::forward(chain, q), q};
}

struct Off {
  Real place, turn;
};
Off offOf(const chain::Chain& chain, std::span<const double> q, const Pose& X_WT) {
  const oracle::ChainPose pose = oracle::chainPose(chain, oracle::realOf(q));
  return {norm(pose.p_WT - real(X_WT.translation())), oracle::angleOf(pose.R_WT, oracle::columnsOf(X_WT.linear()))};
}

constexpr double kEdge = 3e-9;  // of the reach, and rad: what solveAll() promises on the edge
constexpr double kClosedPromised = 128.0;

Outcome judgeClosedForm(Input& input) {
  const chain::Chain chain = drawShippedArm(input);
  const Asked asked = drawAsked(input, chain);
  const std::optional<chain::SphericalWristArm> arm = chain::recognise(chain);
  if (!arm) return {kInfinity, false};
  const chain::Solutions found = asTheServo([&] { return chain::solveAll(*arm, asked.X_WT); });
  if (found.exact == 0) return {kInfinity, false};  // the joints that it was made from are a solution
  const Real reach = Real(arm->reach_m) + largestOf(Vec3(asked.X_WT.translation()));
  const bool is_regular = found.exact == 8;
  const Real unit_of = is_regular ? Real(1) : Real(kEdge) / (Real(0x1p-52) * kClosedPromised);
  double worst = 0.0;
  for (std::size_t i = 0; i < found.exact; ++i) {
    const Off off = offOf(chain, found.all[i].q, asked.X_WT);
    worst = std::max({worst, ulpsOf(off.place, reach * unit_of), ulpsOf(off.turn, unit_of)});
  }
  return {worst, !is_regular};
}

Outcome judgeNumeric(Input& input) {
  const chain::Chain chain = drawChain(input, 8);
  const double reach_m = chain::reachOf(chain);
  std::vector<double> start;
  const std::vector<double> q = drawJoints(input, chain);
  for (const double value : q)
    start.push_back(input.number("start", [&](Dice& dice) { return value * (1.0 + 0.2 * dice.between(-1, 1)); }));
  const Pose X_WT = chain::forward(chain, q);
  chain::NumericOptions options;
  options.tolerance_m = 1e-9 * reach_m;
  const chain::NumericSolution got = asTheServo([&] { return chain::solveNumerically(chain, X_WT, start, options); });
  for (const double value : got.q) {
    if (!std::isfinite(value)) return {kInfinity, false};
  }
  // Reached or not, the reported residual is right; and what is reported as reached is within the tolerances.
  const Off off = offOf(chain, std::span<const double>(got.q).first(chain.joints.size()), X_WT);
  Real turn = 1, place = largestOf(Vec3(X_WT.translation()));
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const bool turns = chain.joints[i].type == chain::JointType::Revolute;
    // The residual is that before the angles were wrapped.
    turn += turns ? std::max(std::abs(got.q[i]), std::abs(start[i])) : 0.0;
    place += turns ? 0.0 : std::max(std::abs(got.q[i]), std::abs(start[i]));
    place = std::max(place, Real(largestOf(chain.joints[i].p_WJ)));
  }
  const bool is_true =
      !got.reached || (got.residual_m <= options.tolerance_m && got.residual_rad <= options.tolerance_rad);
  if (!is_true) return {kInfinity, false};
  return {std::max(ulpsOf(got.residual_m, off.place, place * turn), ulpsOf(got.residual_rad, off.turn, turn)),
          !got.reached};
}

constexpr std::array<Row, 2> kRows{{
    {"chain_closed_form", Kind::Solver, "All joints of the shipped arms for a pose, there and back, near singular ones",
     "ulp of the reach and of 1 rad; where answers merge 3e-9 of them", kClosedPromised, 25, judgeClosedForm},
    {"chain_numeric", Kind::Solver, "Numeric inverse of any chain of 1 to 8 joints: what it says is left, and reached",
     "ulp as of chain_forward", 128, 6, judgeNumeric},
}};

}  // namespace chain_solvers_rows

constinit const std::span<const Row> kChainSolverRows = chain_solvers_rows::kRows;

}  // namespace underact::error_bounds
