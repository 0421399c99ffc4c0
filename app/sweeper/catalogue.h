#pragma once
#include <span>
#include <string_view>

#include "core/sweep/kind.h"

namespace underact::sweep {

/// All kinds of sweeps, in the order of `underact-sweep list`.
std::span<const SweepKind> kinds();

/// The kind of that key, or null.
const SweepKind* findKind(std::string_view key);

/// Scenes on the simulated arm, in hands that differ in mass, damping, stiffness and tremor. Each cell is what
/// `underact-cli run --fast` does with the same scene, hand, rate and seed, to the bit.
SweepKind handsKind();

/// The stiffness limits of walls against their damping: the cells of the lab's maps, and randomly drawn walls.
SweepKind stabilityKind();

}  // namespace underact::sweep
