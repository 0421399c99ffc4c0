#pragma once
#include <array>
#include <cstdint>
#include <variant>

#include "core/chain/closed_form.h"
#include "core/chain/numeric_inverse.h"
#include "core/chain/planar_inverse.h"
#include "core/chain/three_parallel.h"

namespace underact::chain {

/// What a pose asks of a chain: all of it, or, of up to three joints that do not move in a plane, the position alone.
enum class Asks : std::uint8_t { Pose, Position };

/// Three joints of any kind that bring the tip (or the wrist's centre) to a position.
struct PositionArm {
  std::array<Joint, 3> joints;
  Vec3 p_home = Vec3::Zero();
};

/// Three joints of any kind, then three revolute ones whose axes meet in a point C: the Stanford arm, and every arm
/// with a wrist that SphericalWristArm does not know.
struct WristArm {
  PositionArm arm;  // p_home: C
  WristAxes wrist;
  Mat3 R_TW = Mat3::Identity();  // of the tip at home
  Vec3 p_TC = Vec3::Zero();
};

/// A chain and the closed form that its geometry has. Made by inverseOf().
struct Inverse {
  Chain chain;
  Chain read;             // the chain in the direction in which the form fits
  bool reversed = false;  // read is the chain from its tip to its base: a wrist at the base, axes 3, 4 and 5 parallel
  Asks asks = Asks::Pose;
  double reach_m = 1.0;
  std::variant<std::monostate, SphericalWristArm, ThreeParallelArm, PlanarArm, PositionArm, WristArm> form;
  /// Whether there is one.
  bool isClosed() const { return form.index() != 0; }
};

/// Looks for a closed form, in this order: a spherical wrist after parallel axes 2 and 3, the same read from the tip;
/// three parallel axes 2, 3 and 4, the same read from the tip; all axes parallel or at right angles (planar arms and
/// SCARAs); three joints for a position; any three joints before a spherical wrist, the same read from the tip. By the
/// geometry alone, to 1e-9 rad and of the reach.
Inverse inverseOf(const Chain& chain);

/// The chain read from its tip to its base: X(q) of the one is the inverse of X(q reversed) of the other.
Chain reversedChain(const Chain& chain);

/// What a solution of solveAll() is called by: the names that the form has, each with the choice it made.
struct BranchName {
  const char* name = nullptr;  // "shoulder", "elbow", "wrist": +1 or -1; "arm": 1, 2, ... of a form without such names
  int choice = 0;
};

/// One set of joint values that reaches the pose (or position), revolute ones in (-pi, pi].
struct InverseSolution {
  JointValues q{};
  std::array<BranchName, 3> branch{};
  double residual_m = 0.0;
  double residual_rad = 0.0;
};

/// Whether each joint of a is within the tolerance of that of b: rad, whole turns apart or not, or shares of the reach
/// where it slides. reach_m: above 0.
bool areSame(const Chain& chain, const JointValues& a, const JointValues& b, double reach_m, double tolerance);

/// All that there are, at most 16. Joint limits are not asked for.
struct InverseSolutions {
  std::array<InverseSolution, 16> all{};
  std::size_t count = 0;
};

/// Every solution of the closed form for X_WT, within 1e-9 m and rad (times the reach, above 1 m), as polished by
/// Newton's steps where the form is not exact itself. Where solutions coincide there is one of them. None where there
/// is no form, where the pose is out of reach, or, of a chain of fewer than six joints, where it is none that it can
/// take. Not for the servo thread.
InverseSolutions solveAll(const Inverse& inverse, const Pose& X_WT);

}  // namespace underact::chain
