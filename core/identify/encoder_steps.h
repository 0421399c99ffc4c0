#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/identify/estimate.h"
#include "core/identify/swing.h"

namespace underact::identify {

/// The step of a signal that moves in even steps: every change of it is a whole number of them, the smallest ones seen
/// decide. Estimate: of the step, in the signal's unit. None: too few changes, or they are no multiples of one step.
std::optional<Estimate> stepOf(std::span<const double> signal);

/// Counts per turn of a joint of the device from its angles. None: it hardly moved, or they come in no steps.
std::optional<Estimate> countOf(std::span<const double> angles_rad);

/// Root mean square of the tip about its mean, per axis, m. rows: in which it is at rest.
Vec3 restNoise(std::span<const Row> rows);

/// The same about a parabola through each tenth of a second, m: what encoders add to a slow motion. Stretches in which
/// the tip moves less than 0.1 mm are at rest, and left out; none is left: not a number.
Vec3 slowNoise(std::span<const Row> rows, double period_s);

}  // namespace underact::identify
