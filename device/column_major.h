#pragma once
#include <array>

#include "core/base/types.h"

namespace underact::device {

/// A 4x4 transform as OpenHaptics hands it over: column by column, mm, so that the place stands in entries 12 to 14.
/// Only drivers see it; everything above them speaks Pose. Source: Beckman 2007, eq. 5.1.
using ColumnMajor = std::array<double, 16>;

/// The rotation is taken as it is.
Pose poseFrom(const ColumnMajor& T_mm) noexcept;
ColumnMajor columnMajorFrom(const Pose& X_WT) noexcept;

}  // namespace underact::device
