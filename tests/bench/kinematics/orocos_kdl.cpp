#include <benchmark/benchmark.h>

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainjnttojacsolver.hpp>

#include "core/chain/kinematics.h"
#include "tests/bench/kinematics/table.h"
#include "tests/support/random.h"

namespace underact::bench {
namespace {

KDL::Frame frameOf(const Pose& X) {
  const Mat3 R = X.linear();
  return {KDL::Rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
          KDL::Vector(X.translation().x(), X.translation().y(), X.translation().z())};
}

/// KDL's joint turns before its segment's frame; a Craig row's last half therefore goes with the next one's first.
KDL::Chain chainOf(const chain::test::Arm& arm) {
  const auto before = [&](std::size_t i) {
    return KDL::Frame(KDL::Rotation::RotX(arm.rows[i].alpha_rad)) * KDL::Frame(KDL::Vector(arm.rows[i].a_m, 0, 0));
  };
  KDL::Chain chain;
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), frameOf(arm.X_WB) * before(0)));
  for (std::size_t i = 0; i < arm.rows.size(); ++i) {
    const KDL::Frame after(KDL::Rotation::RotZ(arm.rows[i].theta_rad), KDL::Vector(0, 0, arm.rows[i].d_m));
    const bool last = i + 1 == arm.rows.size();
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ), after * (last ? frameOf(arm.X_NT) : before(i + 1))));
  }
  return chain;
}

std::vector<KDL::JntArray> jointsOf(const std::vector<std::vector<double>>& values) {
  std::vector<KDL::JntArray> joints;
  for (const std::vector<double>& one : values) {
    joints.emplace_back(static_cast<unsigned>(one.size()));
    for (std::size_t i = 0; i < one.size(); ++i) joints.back()(static_cast<unsigned>(i)) = one[i];
  }
  return joints;
}

Line numericByKdl(const Cases& cases, const KDL::Chain& chain, const std::vector<std::vector<double>>& seeds,
                  int restarts, const char* task) {
  Line line{cases.arm.name, task, "KDL LMA"};
  KDL::ChainIkSolverPos_LMA solver(chain, 1e-9);  // as near as ours is asked to come; its steps and weights as shipped
  const std::vector<KDL::JntArray> starts = jointsOf(seeds);
  std::vector<KDL::Frame> wanted;
  for (const Pose& X_WT : cases.X_WT) wanted.push_back(frameOf(X_WT));
  const unsigned joints = static_cast<unsigned>(cases.arm.rows.size());
  KDL::JntArray found(joints), start(joints);
  const auto solve = [&](std::size_t i) {
    test::Random random({i});
    start = starts[i];
    for (int turn = 0;; ++turn) {
      if (solver.CartToJnt(start, wanted[i], found) == 0 || turn == restarts) return;
      for (unsigned j = 0; j < joints; ++j) start(j) = random.between(-3.14159, 3.14159);
    }
  };
  line.median_ns = medianOf(cases.q.size(), solve);
  Score score;
  for (std::size_t i = 0; i < cases.q.size(); ++i) {
    solve(i);
    score.add(chain::forward(cases.chain, {found.data.data(), joints}), cases.X_WT[i]);
  }
  score.into(line);
  return line;
}

}  // namespace

Lines orocosKdl(const Cases& cases) {
  const KDL::Chain chain = chainOf(cases.arm);
  const std::vector<KDL::JntArray> q = jointsOf(cases.q);
  KDL::ChainFkSolverPos_recursive forward_solver(chain);
  KDL::ChainJntToJacSolver jacobian_solver(chain);
  KDL::Frame frame;
  KDL::Jacobian jacobian(static_cast<unsigned>(cases.arm.rows.size()));
  Line forward{cases.arm.name, "forward", "KDL"}, both{cases.arm.name, "forward and Jacobian", "KDL"};
  forward.median_ns = medianOf(q.size(), [&](std::size_t i) {
    forward_solver.JntToCart(q[i], frame);
    benchmark::DoNotOptimize(frame);
  });
  both.median_ns = medianOf(q.size(), [&](std::size_t i) {
    forward_solver.JntToCart(q[i], frame);
    jacobian_solver.JntToJac(q[i], jacobian);
    benchmark::DoNotOptimize(jacobian);
  });
  Score score;  // of KDL's pose against ours: the chain is the same one
  for (std::size_t i = 0; i < q.size(); ++i) {
    forward_solver.JntToCart(q[i], frame);
    Pose X_WT = Pose::Identity();
    for (int row = 0; row < 3; ++row) {
      X_WT.translation()[row] = frame.p(row);
      for (int column = 0; column < 3; ++column) X_WT.linear()(row, column) = frame.M(row, column);
    }
    score.add(X_WT, cases.X_WT[i]);
  }
  score.into(forward);
  forward.note = "errors: against ours";
  return {forward, both, numericByKdl(cases, chain, cases.near, 0, "inverse, one, from 0.1 rad off"),
          numericByKdl(cases, chain, cases.far, 0, "inverse, one, from anywhere"),
          numericByKdl(cases, chain, cases.far, kRestarts, "inverse, one, with 20 restarts")};
}

}  // namespace underact::bench
