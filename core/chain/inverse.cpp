#include "core/chain/inverse.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/base/rotation.h"
#include "core/chain/normal_equations.h"
#include "core/chain/position_inverse.h"
#include "core/chain/trig_equation.h"

namespace underact::chain {
namespace {

constexpr double kReached = 1e-9;     // m (of reaches above 1 m their share) and rad
constexpr double kPolished = 1e-14;   // below this a step would be rounding
constexpr double kCandidate = 0.05;   // of the reach, and rad: further off, an answer of a form is none
constexpr double kSameAnswer = 1e-6;  // rad, and of the reach
constexpr int kPolishSteps = 6;

std::optional<WristArm> wristArm(const Chain& chain) {
  if (chain.joints.size() != 6) return std::nullopt;
  const std::span<const Joint> joints(chain.joints);
  const std::optional<Vec3> centre = meetingPoint(joints.last<3>(), kSame * reachOf(chain));
  if (!centre || !placesPoint(joints.first<3>(), *centre)) return std::nullopt;
  WristArm arm;
  std::copy_n(joints.begin(), 3, arm.arm.joints.begin());
  arm.arm.p_home = *centre;
  arm.wrist = wristAxes(joints[3].axis_W, joints[4].axis_W, joints[5].axis_W);
  arm.R_TW = chain.X_WT_home.linear().transpose();
  arm.p_TC = arm.R_TW * (*centre - chain.X_WT_home.translation());
  return arm;
}

std::optional<PositionArm> positionArm(const Chain& chain) {
  if (chain.joints.size() != 3) return std::nullopt;
  const std::span<const Joint, 3> joints(chain.joints.data(), 3);
  const Vec3 p_home = chain.X_WT_home.translation();
  if (!placesPoint(joints, p_home)) return std::nullopt;
  return PositionArm{{joints[0], joints[1], joints[2]}, p_home};
}

/// The chain with the first joints alone, whose last link carries the point.
Mat3 rotationOf(const std::array<Joint, 3>& joints, const std::array<double, 3>& q) {
  Mat3 R = Mat3::Identity();
  for (std::size_t i = 3; i-- > 0;) {
    if (joints[i].type != JointType::Revolute) continue;
    const SinCos turn = sinCos(q[i]);
    for (Eigen::Index column = 0; column < 3; ++column) R.col(column) = rotated(R.col(column), joints[i].axis_W, turn);
  }
  return R;
}

/// Collects what is near enough to be a solution, polished, each once.
class Collected {
 public:
  Collected(const Chain& chain, const Pose& X_WT, Asks asks, double reach_m, InverseSolutions& found)
      : chain_(chain), X_WT_(X_WT), rows_(asks == Asks::Pose ? 6 : 3), reach_m_(reach_m), found_(found) {}

  /// polish false: the form is exact, and its residual need not be looked at.
  void add(InverseSolution& one, bool polish) {
    if (polish && !polished(one)) return;
    for (std::size_t i = 0; i < chain_.joints.size(); ++i) {
      if (chain_.joints[i].type != JointType::Revolute) continue;
      one.q[i] = wrapped(one.q[i]);
      if (one.q[i] <= -kPi) one.q[i] = kPi;
    }
    for (std::size_t i = 0; i < found_.count; ++i) {
      if (areSame(chain_, found_.all[i].q, one.q, std::max(reach_m_, 1e-300), kSameAnswer)) return;
    }
    if (found_.count < found_.all.size()) found_.all[found_.count++] = one;
  }

 private:
  bool polished(InverseSolution& one) const {
    const double scale_m = std::max(1.0, reach_m_), length_m = reach_m_ > 0.0 ? reach_m_ : 1.0;
    for (int step = 0; step <= kPolishSteps; ++step) {
      const Kinematics now = kinematics(chain_, std::span<const double>(one.q).first(chain_.joints.size()));
      const Vec3 offset_W = X_WT_.translation() - now.X_WT.translation();
      const Vec3 turn_W =
          rows_ == 6 ? rotationVector(X_WT_.linear() * now.X_WT.linear().transpose()) : Vec3(Vec3::Zero());
      one.residual_m = offset_W.norm();
      one.residual_rad = turn_W.norm();
      const double off = std::max(one.residual_m / length_m, one.residual_rad);
      if (!(off <= kCandidate)) return false;
      if (off <= kPolished || step == kPolishSteps) break;
      Residual e;
      e << offset_W, length_m * turn_W;
      Jacobian J = now.J;
      J.bottomRows<3>() *= length_m;
      JointStep dq;
      if (!dampedStep(J, e, rows_, 1e-3 * e.squaredNorm() + 1e-15 * length_m * length_m, 0, dq)) break;
      for (std::size_t i = 0; i < chain_.joints.size(); ++i) one.q[i] += dq[static_cast<Eigen::Index>(i)];
    }
    return one.residual_m <= kReached * scale_m && one.residual_rad <= kReached;
  }

  const Chain& chain_;
  const Pose& X_WT_;
  std::size_t rows_;
  double reach_m_;
  InverseSolutions& found_;
};

template <class Angles>
InverseSolution valuesOf(const Angles& q) {
  InverseSolution one;
  std::copy(q.begin(), q.end(), one.q.begin());
  return one;
}

/// A solution of a form with shoulder, elbow and wrist.
template <class From>
InverseSolution withBranches(const From& from) {
  InverseSolution one = valuesOf(from.q);
  one.branch = {{{"shoulder", from.shoulder}, {"elbow", from.elbow}, {"wrist", from.wrist}}};
  return one;
}

void solveForm(const SphericalWristArm& arm, const Chain&, const Pose& X_WT, Collected& found) {
  const Solutions all = solveAll(arm, X_WT);
  for (std::size_t i = 0; i < all.exact; ++i) {
    InverseSolution one = withBranches(all.all[i]);
    found.add(one, false);
  }
}

void solveForm(const ThreeParallelArm& arm, const Chain&, const Pose& X_WT, Collected& found) {
  const ThreeParallelSolutions all = solveAll(arm, X_WT);
  for (std::size_t i = 0; i < all.count; ++i) {
    InverseSolution one = withBranches(all.all[i]);
    found.add(one, !all.all[i].exact);
  }
}

void solveForm(const PlanarArm& arm, const Chain& chain, const Pose& X_WT, Collected& found) {
  const Mat3 R = X_WT.linear() * chain.X_WT_home.linear().transpose();
  const Vec3 across = arm.normal_W.unitOrthogonal(), p_home = chain.X_WT_home.translation();
  const PlanarMotion wanted{angleAbout(arm.normal_W, across, R * across), p_home, X_WT.translation()};
  const PlanarAnswers answers = solvePlanar(arm.normal_W, arm.level, wanted);
  for (std::size_t i = 0; i < answers.count; ++i) {
    InverseSolution one;
    for (std::size_t j = 0; j < arm.level.size(); ++j) one.q[arm.which[j]] = arm.sign[j] * answers.all[i][j];
    if (arm.quill) one.q[*arm.quill] = arm.quill_sign * arm.normal_W.dot(X_WT.translation() - p_home);
    if (arm.level.size() > 1) one.branch[0] = {"elbow", i == 0 ? 1 : -1};
    found.add(one, true);
  }
}

void solveForm(const PositionArm& arm, const Chain&, const Pose& X_WT, Collected& found) {
  const PositionAnswers answers = solvePosition(arm.joints, arm.p_home, X_WT.translation());
  for (std::size_t i = 0; i < answers.count; ++i) {
    InverseSolution one = valuesOf(answers.all[i]);
    one.branch[0] = {"arm", static_cast<int>(i) + 1};
    found.add(one, true);
  }
}

void solveForm(const WristArm& arm, const Chain&, const Pose& X_WT, Collected& found) {
  const Vec3 p_WC = X_WT.translation() + X_WT.linear() * arm.p_TC;
  const Mat3 R = X_WT.linear() * arm.R_TW;
  const PositionAnswers answers = solvePosition(arm.arm.joints, arm.arm.p_home, p_WC);
  for (std::size_t i = 0; i < answers.count; ++i) {
    const Mat3 seen = rotationOf(arm.arm.joints, answers.all[i]).transpose() * R;
    const WristAnswers wrists = solveWrist(arm.wrist, {seen * arm.wrist.axis_W[2], seen * arm.wrist.across_W});
    for (int j = 0; j < wrists.count; ++j) {
      InverseSolution one = valuesOf(answers.all[i]);
      const std::array<double, 3>& q = wrists.all[static_cast<std::size_t>(j)].q;
      std::copy(q.begin(), q.end(), one.q.begin() + 3);
      one.branch[0] = {"arm", static_cast<int>(i) + 1};
      one.branch[1] = {"wrist", 1 - 2 * j};
      found.add(one, true);
    }
  }
}

void solveForm(const std::monostate&, const Chain&, const Pose&, Collected&) {}

/// One of the forms that fit in either direction.
template <class Form>
bool fits(Inverse& inverse, const Chain& backwards, std::optional<Form> (*find)(const Chain&)) {
  for (const bool reversed : {false, true}) {
    const Chain& chain = reversed ? backwards : inverse.chain;
    std::optional<Form> form = find(chain);
    if (!form) continue;
    inverse.form = std::move(*form);
    inverse.read = chain;
    inverse.reversed = reversed;
    return true;
  }
  return false;
}

std::optional<SphericalWristArm> sphericalWristArm(const Chain& chain) {
  return recognise(chain);
}
std::optional<ThreeParallelArm> parallelArm(const Chain& chain) {
  return threeParallelArm(chain);
}

}  // namespace

bool areSame(const Chain& chain, const JointValues& a, const JointValues& b, double reach_m, double tolerance) {
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const bool turns = chain.joints[i].type == JointType::Revolute;
    const double off = turns ? std::abs(wrapped(a[i] - b[i])) : std::abs(a[i] - b[i]) / reach_m;
    if (!(off <= tolerance)) return false;
  }
  return true;
}

Chain reversedChain(const Chain& chain) {
  Chain other;
  const Mat3 R_TW = chain.X_WT_home.linear().transpose();
  const Vec3& p_WT = chain.X_WT_home.translation();
  for (std::size_t i = chain.joints.size(); i-- > 0;) {
    Joint joint = chain.joints[i];
    joint.axis_W = -(R_TW * joint.axis_W);
    joint.p_WJ = R_TW * (joint.p_WJ - p_WT);
    other.joints.push_back(joint);
  }
  other.X_WT_home.linear() = R_TW;
  other.X_WT_home.translation() = -(R_TW * p_WT);
  return other;
}

Inverse inverseOf(const Chain& chain) {
  Inverse inverse;
  inverse.chain = chain;
  inverse.reach_m = reachOf(chain);
  inverse.read = chain;
  const Chain backwards = reversedChain(chain);
  if (chain.joints.size() == 6 && (fits(inverse, backwards, sphericalWristArm) ||
                                   fits(inverse, backwards, parallelArm) || fits(inverse, backwards, wristArm)))
    return inverse;
  if (std::optional<PlanarArm> planar = planarArm(chain)) {
    inverse.asks = planar->level.size() == 3 ? Asks::Pose : Asks::Position;
    inverse.form = std::move(*planar);
    return inverse;
  }
  inverse.asks = chain.joints.size() <= 3 ? Asks::Position : Asks::Pose;
  if (const std::optional<PositionArm> position = positionArm(chain)) inverse.form = *position;
  return inverse;
}

InverseSolutions solveAll(const Inverse& inverse, const Pose& X_WT) {
  if (!X_WT.matrix().allFinite()) return {};
  Pose X_Read = X_WT;
  if (inverse.reversed) {
    X_Read.linear() = X_WT.linear().transpose();
    X_Read.translation() = -(X_Read.linear() * X_WT.translation());
  }
  InverseSolutions solutions;
  Collected found(inverse.read, X_Read, inverse.asks, inverse.reach_m, solutions);
  std::visit([&](const auto& form) { solveForm(form, inverse.read, X_Read, found); }, inverse.form);
  if (!inverse.reversed) return solutions;
  const std::ptrdiff_t joints = static_cast<std::ptrdiff_t>(inverse.chain.joints.size());
  for (std::size_t i = 0; i < solutions.count; ++i)
    std::reverse(solutions.all[i].q.begin(), solutions.all[i].q.begin() + joints);
  return solutions;
}

}  // namespace underact::chain
