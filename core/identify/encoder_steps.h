#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/identify/estimate.h"
#include "core/identify/swing.h"

namespace underact::identify {

/// The step of a signal that changes in equal steps: every change is a whole number of them, and the smallest changes
/// decide. Estimate: of the step, in the signal's unit. None: too few changes, or no common step.
std::optional<Estimate> stepOf(std::span<const double> signal);

/// Counts per turn of a joint of the device from its angles. None: it hardly moved, or its angles show no steps.
std::optional<Estimate> countOf(std::span<const double> angles_rad);

/// Root mean square of the tip about its mean, per axis, m. rows: in which it is at rest.
Vec3 restNoise(std::span<const MotionRow> rows);

/// Scatter about a parabola through each tenth of a second, m: the noise that encoders add to a slow motion. Stretches
/// in which the tip moves less than 0.1 mm are left out; where none remains, not a number.
Vec3 slowNoise(std::span<const MotionRow> rows, double period_s);

}  // namespace underact::identify
