#include <array>

#include "core/base/norms.h"
#include "core/chain/dh.h"
#include "core/chain/kinematics.h"
#include "tests/error_bounds/oracle/chain.h"
#include "tests/error_bounds/rows/draws.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace chains_rows {

/// The effect of rounding of the angles at the tip: the lengths of all links, times the sum of the angles (1 rad at
/// least).
struct Scales {
  Real place, turn;
};
Scales scalesOf(const chain::Chain& chain, const std::vector<double>& q) {
  Real turn = 1, place = 0;
  double slid_m = 0.0;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    if (chain.joints[i].type == chain::JointType::Revolute) {
      turn += std::abs(q[i]);
      place = std::max(place, Real(largestOf(chain.joints[i].p_WJ)));
    } else {
      slid_m += std::abs(q[i]);
    }
  }
  place = std::max(place, Real(largestOf(chain.X_WT_home.translation()))) + slid_m;
  return {place * turn, turn};
}

Outcome judgeForward(Input& input) {
  const chain::Chain chain = drawChain(input);
  const std::vector<double> q = drawJoints(input, chain);
  const Pose got = asTheServo([&] { return chain::forward(chain, q); });
  const oracle::ChainPose right = oracle::chainPose(chain, oracle::realOf(q));
  const Scales scales = scalesOf(chain, q);
  return {std::max(ulpsOf(Vec3(got.translation()), right.p_WT, scales.place),
                   oracle::ulpsOf(got.linear(), right.R_WT, scales.turn)),
          false};
}

Outcome judgeJacobian(Input& input) {
  const chain::Chain chain = drawChain(input);
  const std::vector<double> q = drawJoints(input, chain);
  const std::size_t joint = input.choice("column", chain.joints.size());
  const chain::Jacobian J = asTheServo([&] { return chain::jacobian(chain, q); });
  const oracle::Twist right = oracle::chainTwist(chain, oracle::realOf(q), joint);
  const Scales scales = scalesOf(chain, q);
  const auto column = static_cast<Eigen::Index>(joint);
  return {std::max(ulpsOf(Vec3(J.col(column).head<3>()), right.v, scales.place + scales.turn),
                   ulpsOf(Vec3(J.col(column).tail<3>()), right.w, scales.turn)),
          false};
}

Outcome judgeDhRow(Input& input) {
  chain::DhRow row;
  row.type = input.flag("slides") ? chain::JointType::Prismatic : chain::JointType::Revolute;
  row.alpha_rad = input.number("alpha_rad", [](Dice& dice) { return dice.angle(); });
  row.a_m = input.number("a_m", [](Dice& dice) { return dice.sign() * dice.scale(); });
  row.theta_rad = input.number("theta_rad", [](Dice& dice) { return dice.angle(); });
  row.d_m = input.number("d_m", [&](Dice& dice) { return row.a_m * dice.ratio(); });
  const double q = input.number(
      "q", [&](Dice& dice) { return row.type == chain::JointType::Prismatic ? row.a_m * dice.ratio() : dice.angle(); });
  const Pose got = asTheServo([&] { return chain::rowPose(row, q); });
  const bool slides = row.type == chain::JointType::Prismatic;
  const Real theta = Real(row.theta_rad) + (slides ? 0.0 : q), d = Real(row.d_m) + (slides ? q : 0.0);
  using oracle::about;
  using oracle::Motion;
  const Motion right = Motion{about({1, 0, 0}, row.alpha_rad), {row.a_m, 0, 0}} *
                       Motion{about({0, 0, 1}, theta), {0, 0, 0}} * Motion{oracle::Quaternion{}, {0, 0, d}};
  const Real turn = 1 + abs(Real(row.theta_rad)) + abs(Real(slides ? 0.0 : q)) + abs(Real(row.alpha_rad));
  const Real place = abs(Real(row.a_m)) + abs(Real(row.d_m)) + abs(Real(slides ? q : 0.0));
  return {std::max(ulpsOf(Vec3(got.translation()), right.shift, place * turn),
                   oracle::ulpsOf(got.linear(), oracle::columnsOf(right.turn), turn)),
          false};
}

constexpr const char* kPromise =
    "ulp of the largest coordinate of joints and tip at home times the sum of the angles (1 rad at least), and of the "
    "slides";

constexpr std::array<Row, 3> kRows{{
    {"chain_forward", Kind::Chain, "Pose of any chain of 1 to 16 joints", kPromise, 64, 3, judgeForward},
    {"chain_jacobian", Kind::Chain, "Jacobian of any chain of 1 to 16 joints", kPromise, 64, 4, judgeJacobian},
    {"chain_dh", Kind::Chain, "A row of a Denavit-Hartenberg table",
     "ulp of its lengths times its angles (1 rad at least); of its angles for the orientation", 8, 1, judgeDhRow},
}};

}  // namespace chains_rows

constinit const std::span<const Row> kChainRows = chains_rows::kRows;

}  // namespace underact::error_bounds
