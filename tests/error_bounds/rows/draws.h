#pragma once
#include <array>
#include <limits>
#include <vector>

#include "core/arm/preset.h"
#include "core/chain/chain.h"
#include "core/manipulator/manipulator.h"
#include "tests/error_bounds/input.h"

namespace underact::error_bounds {

// Inputs of rows about chains.

/// 1 to most joints of both types, 2^-size to 2^size m; axes sometimes in one line, parallel or intersecting.
chain::Chain drawChain(Input& input, std::size_t max = chain::kMaxJoints, int size = 40);
/// A value for each joint: angles as Dice::angle(), slides of the chain's own scale.
std::vector<double> drawJoints(Input& input, const chain::Chain& chain);

// Inputs of rows about the arm.

/// Lengths: a real arm's, or 2^-size to 2^size m; the base at the origin or near it.
arm::Geometry drawArm(Input& input, int size = 40);
/// Within a turn, near the quarter turns where the arm is singular, sometimes up to 1e6 rad.
arm::JointAngles drawJoints(Input& input);

// Inputs of rows about virtual robots.

/// 1 to 8 joints of any kind, 2^-size to 2^size m; orientation none, axis or full.
manipulator::Manipulator drawManipulator(Input& input, int size = 40);
/// One or two joints with a closed form, with and without limits.
manipulator::Manipulator drawClosedManipulator(Input& input);
/// A stylus near it, or far away.
Pose drawStylus(Input& input, const manipulator::Manipulator& m);
/// A value for each joint of the manipulator as drawJoints(); 0 beyond.
manipulator::Values drawTheta(Input& input, const manipulator::Manipulator& m);

// Inputs of rows about laws and filters: a signal, sample by sample.

/// Samples of the error and the time before each.
struct Signal {
  std::vector<Vec3> e_W;
  std::vector<double> dt_s;  // before each sample
};

/// count samples at a rate from 1 Hz to 100 kHz: a walk in steps of an encoder or of any size, about zero or far from
/// it; sometimes no time passes, or the rate jitters. Computed from a few drawn numbers, so a stored case is short.
Signal drawSignal(Input& input, int count);

/// Numbers that no arm sends.
inline constexpr std::array<double, 14> kOddNumbers{
    kNotANumber, kInfinity, -kInfinity, 5e-324, -5e-324, 1e-310, 1e308,
    -1e308,      1e200,     -1e155,     1e-200, -0.0,    1e18,   std::numeric_limits<double>::max()};

/// One of kOddNumbers, equally likely.
inline double drawOdd(Dice& dice) {
  return kOddNumbers[dice.below(kOddNumbers.size())];
}

}  // namespace underact::error_bounds
