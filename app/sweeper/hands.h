#pragma once
#include "core/sweep/kind.h"

namespace underact::sweep {

/// Scenes on the simulated arm, in hands that differ in mass, damping, stiffness and tremor. Each cell is what
/// `underact-cli run --fast` does with the same scene, hand, rate and seed, to the bit.
Kind handsKind();

}  // namespace underact::sweep
