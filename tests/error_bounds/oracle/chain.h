#pragma once
#include <span>
#include <vector>

#include "core/chain/chain.h"
#include "tests/error_bounds/oracle/turns.h"

namespace underact::error_bounds::oracle {

/// The orientation of the tip, by columns, and its position in W.
struct ChainPose {
  Columns R_WT;
  Real3 p_WT;
};
/// The pose of the tip as a product of screws, with quaternions and shifts. The axes are taken as unit.
ChainPose chainPose(const chain::Chain& chain, const std::vector<Real>& q);
/// The doubles, exactly.
std::vector<Real> realOf(std::span<const double> q);

/// The velocity of the tip by a joint, by difference quotients (see armJacobian()).
struct Twist {
  Real3 v, w;
};
/// v of the tip, w of its frame, in W, per rad or m of that joint. joint: below the size of q.
Twist chainTwist(const chain::Chain& chain, std::vector<Real> q, std::size_t joint);

}  // namespace underact::error_bounds::oracle
