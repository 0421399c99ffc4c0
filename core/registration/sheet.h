#pragma once
#include <cstddef>
#include <vector>

#include "core/base/types.h"

namespace underact::registration {

/// The reference points of the printed sheet, p_DM, m: the first is the origin of D. The first `count` of them, 3 to 8.
/// No two distances between the first three are equal, so that only the right order fits.
std::vector<Vec3> sheetPoints(std::size_t count = 3);

/// A position on the desk as measured from the first reference point: to the right, away from the person, up.
Vec3 onDesk(double right_m, double away_m, double up_m);
// The three numbers of a position on the desk, in the unit of p_D.
double rightOf(const Vec3& p_D);
double awayOf(const Vec3& p_D);
double upOf(const Vec3& p_D);

}  // namespace underact::registration
