#pragma once
#include <vector>

#include "core/chain/chain.h"
#include "core/extremes/input.h"

namespace underact::extremes {

// What rows that ask chains draw.

/// 1 to most joints of both types, 2^-size to 2^size m; axes in one line, parallel or crossing now and then.
chain::Chain drawChain(Input& input, std::size_t most = chain::kMaxJoints, int size = 40);
/// A value for each joint: angles as Dice::angle(), slides of the chain's own scale.
std::vector<double> drawJoints(Input& input, const chain::Chain& chain);

}  // namespace underact::extremes
