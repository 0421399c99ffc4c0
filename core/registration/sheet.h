#pragma once
#include <cstddef>
#include <vector>

#include "core/base/types.h"

namespace underact::registration {

/// The marks of the sheet that the program prints, p_DM, m: mark 1 is the origin of D. The first `count` of them, 3 to
/// 8. No two distances between the first three are alike, so that no order fits but the right one.
std::vector<Vec3> sheetMarks(std::size_t count = 3);

/// A place on the desk as people measure it from mark 1: to the right, away from them, up.
Vec3 onDesk(double right_m, double away_m, double up_m);
// The same three numbers of a position on the desk, in the unit of p_D.
double rightOf(const Vec3& p_D);
double awayOf(const Vec3& p_D);
double upOf(const Vec3& p_D);

}  // namespace underact::registration
