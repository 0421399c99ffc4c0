#pragma once
#include <array>
#include <limits>
#include <vector>

#include "core/arm/preset.h"
#include "core/chain/chain.h"
#include "core/extremes/input.h"
#include "core/manipulator/manipulator.h"

namespace underact::extremes {

// What rows that ask chains draw.

/// 1 to most joints of both types, 2^-size to 2^size m; axes in one line, parallel or crossing now and then.
chain::Chain drawChain(Input& input, std::size_t most = chain::kMaxJoints, int size = 40);
/// A value for each joint: angles as Dice::angle(), slides of the chain's own scale.
std::vector<double> drawJoints(Input& input, const chain::Chain& chain);

// What rows that ask the arm draw.

/// Lengths: a real arm's, or 2^-size to 2^size m; the base in the origin or beside it.
arm::Geometry drawArm(Input& input, int size = 40);
/// Within a turn, beside the quarter turns where the arm is singular, seldom of 1e6 rad.
arm::JointAngles drawJoints(Input& input);

// What rows that ask virtual robots draw.

/// 1 to 8 joints of any kind, 2^-size to 2^size m; orientation none, axis or full.
manipulator::Manipulator drawManipulator(Input& input, int size = 40);
/// One or two joints with a closed form, with and without limits.
manipulator::Manipulator drawClosedManipulator(Input& input);
/// A stylus beside it, or far.
Pose drawStylus(Input& input, const manipulator::Manipulator& m);
/// A value for each joint of the manipulator as drawJoints(); 0 beyond.
manipulator::Values drawTheta(Input& input, const manipulator::Manipulator& m);

// What rows that ask laws and filters are fed: a signal, sample by sample.

/// Samples of the error and the time before each.
struct Signal {
  std::vector<Vec3> e_W;
  std::vector<double> dt_s;  // before each sample
};

/// count samples at one rate from 1 Hz to 100 kHz: a walk in steps of an encoder or of any size, about zero or far from
/// it; now and then no time passes, or the rate trembles. Made from numbers that are drawn, so a kept case has few.
Signal drawSignal(Input& input, int count);

/// What no arm sends.
inline constexpr std::array<double, 14> kOddNumbers{
    kNotANumber, kInfinity, -kInfinity, 5e-324, -5e-324, 1e-310, 1e308,
    -1e308,      1e200,     -1e155,     1e-200, -0.0,    1e18,   std::numeric_limits<double>::max()};

/// One of kOddNumbers, equally likely.
inline double drawOdd(Dice& dice) {
  return kOddNumbers[dice.below(kOddNumbers.size())];
}

}  // namespace underact::extremes
