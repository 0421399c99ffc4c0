#pragma once
#include "core/base/sentence.h"
#include "core/base/types.h"

namespace underact {

/// How far the entries of a matrix may be off the nearest rotation for that one to be meant: three decimals are enough.
inline constexpr double kFarthestRotation = 1e-3;

/// The rotation nearest to a matrix, in the sum of the squares of its entries; of one that six decimals leave beside a
/// rotation, the one of its quaternion. A matrix without one, a mirror for example, is given back. Set-up only. Source:
/// Higham 1986, Newton's iteration for the polar factor.
Mat3 nearestRotation(const Mat3& R);

/// R as it is where its six decimals or more say a rotation; else nearestRotation().
Mat3 meantRotation(const Mat3& R);

/// The largest difference of an entry of R from nearestRotation(); infinite where R has none.
double offRotation(const Mat3& R);

/// Empty where the nearest rotation is meant; else why not: how far off, and how many digits are needed.
Sentence rotationProblem(const Mat3& R);

/// Empty for a rotation given with six decimals or more; else that the nearest one is taken, and how far off it is.
Sentence rotationNote(const Mat3& R);

}  // namespace underact
