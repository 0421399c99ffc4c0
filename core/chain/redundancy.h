#pragma once
#include <span>
#include <vector>

#include "core/chain/inverse.h"

namespace underact::chain {

/// The motions of the joints that leave the tip where it is, to first order: an orthonormal basis, a vector of one
/// number for each joint (rad; slides as shares of the reach). relative: a singular value of the Jacobian (lengths in
/// reaches) below this share of the largest counts as zero. Empty: the joints are isolated. Source: Siciliano, 3.5.1.
std::vector<std::vector<double>> nullSpace(const Chain& chain, std::span<const double> q, Asks asks, double relative);

/// One of these motions: its largest number 1; empty where there is none.
std::vector<double> selfMotion(const Chain& chain, std::span<const double> q, Asks asks, double relative);

/// Moves joints that reach X_WT along their null space towards a preferred posture (one number for each joint, rad or
/// m), as near as a local search comes, and keeps the tip within the tolerances of options. q that do not reach it, or
/// have no null space, stay. Source: Siciliano, section 3.7, projection of the gradient.
NumericSolution nearPosture(const Chain& chain, const Pose& X_WT, const NumericSolution& q,
                            std::span<const double> posture, const NumericOptions& options);

/// Every solution that a search from so many starts finds: the first from q_start, the others drawnJoints() from the
/// seed of options, each on its own (no restarts). Each once: joints within 1e-4 rad (or of the reach) of an earlier
/// solution are that. With a null space each start ends somewhere else in it: then as many as were reached.
std::vector<NumericSolution> searchAll(const Chain& chain, const Pose& X_WT, std::span<const double> q_start,
                                       const NumericOptions& options, int starts);

}  // namespace underact::chain
