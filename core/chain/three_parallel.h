#pragma once
#include <array>
#include <optional>

#include "core/base/trig.h"
#include "core/chain/chain.h"

namespace underact::chain {

/// What a joint makes of a vector: fixed + cos q cosine + sin q sine.
struct TurnedVector {
  Vec3 fixed = Vec3::Zero();
  Vec3 cosine = Vec3::Zero();
  Vec3 sine = Vec3::Zero();
  /// At q = -angle, of which these are the sine and cosine.
  Vec3 back(const SinCos& turn) const noexcept UNDERACT_REAL_TIME {
    return fixed + turn.cos * cosine - turn.sin * sine;
  }
};

/// Six revolute joints of which axes 2, 3 and 4 are parallel: Universal Robots' arms and their like. Made by
/// threeParallelArm(). Everything is at home.
struct ThreeParallelArm {
  std::array<Joint, 6> joints;                  // axes 3 and 4 along axis 2
  std::array<double, 6> sign{};                 // -1 where the chain's axis is opposed
  Vec3 p_W56 = Vec3::Zero();                    // the point of axis 6 nearest to axis 5; where they meet, that point
  bool meets = false;                           // axes 5 and 6 meet
  bool exact = false;                           // they do, and the three are parallel, to some roundings
  Pose X_TW = Pose::Identity();                 // of the tip at home
  double upper_m = 0.0, fore_m = 0.0;           // between axes 2 and 3, and 3 and 4
  Vec3 u_W = Vec3::Zero(), v_W = Vec3::Zero();  // unit: along the upper arm, and across it and the three axes
  double ahead = 0.0, aside = 0.0;              // of the forearm's direction, along these
  TurnedVector axis_5, upper_5, p_54_5;         // by joint 5: axis 2, u_W, and the way from axis 5 to axis 4
  double reach_m = 0.0;
};

/// The chain as such an arm; none where axes 1 and 2, 4 and 5 or 5 and 6 are parallel, too, or two of the three
/// coincide.
std::optional<ThreeParallelArm> threeParallelArm(const Chain& chain) noexcept;

/// One solution for a pose, as of SphericalWristArm; rad, in (-pi, pi]. shoulder: joint 1, +1 where it is rotated in
/// the positive sense from the middle of both; wrist: joint 5 the same; elbow: joint 3 the same.
struct ThreeParallelSolution {
  std::array<double, 6> q{};
  int shoulder = 1, elbow = 1, wrist = 1;
  bool exact = true;  // to some roundings; near a straight joint 5 to 2e-10 rad. false: see solveAll()
};
/// What solveAll() found: the first count of all.
struct ThreeParallelSolutions {
  std::array<ThreeParallelSolution, 8> all{};
  std::size_t count = 0;
};

/// Every q with X_WT(q) = X_WT, up to eight; on the boundary two coincide. Singular: axis 6 parallel to the three, with
/// q6 = 0. Not exact, but right to 1e-9 of the reach and rad: where two solutions coincide, where the geometry fits
/// only to so much, or where axes 5 and 6 do not meet, so that joint 1 follows from an equation of degree 4. X_WT: its
/// linear part a rotation. Never NaN. Cost: 1 us. Source: Elias and Wen 2022, "IK-Geo", three parallel.
ThreeParallelSolutions solveAll(const ThreeParallelArm& arm, const Pose& X_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::chain
