#pragma once
#include <cstddef>
#include <vector>

#include "core/base/types.h"
#include "core/registration/fit.h"

namespace underact::registration {

/// The expected error of a touched point, m, root mean square distance from the reference point, from the residual of
/// the fit: rms sqrt(N / (N - 2)), since the fit absorbs part of the error.
/// Source: Fitzpatrick, West, Maurer 1998, eq. 10. marks: 3 at least.
double touchingError_m(double rms_m, std::size_t marks);

/// An upper bound of it that holds in 19 of 20 registrations, since 3N - 6 squares are few. Source: chi-square, 5 %.
/// marks: 3 to 8.
double likelyMax_m(double rms_m, std::size_t marks);

/// The expected error at a point of the desk, m, root mean square, where each reference point was touched with that
/// error: e^2 / N (1 + (d1^2 / f1^2 + d2^2 / f2^2 + d3^2 / f3^2) / 3), with d the point's and f the reference points'
/// root mean square distance from each principal axis of the reference points. points_D: as fitTouches() takes them.
/// Source: Fitzpatrick, West, Maurer 1998, eq. 46.
double expectedError_m(const std::vector<Vec3>& points_D, double touching_m, const Vec3& p_D);

/// The expected error at the middle of the workspace, p_W = 0, m.
struct ErrorInTheMiddle {
  double expected_m = 0.0;
  double likely_max_m = 0.0;  // expected, of likelyMax_m()
};
/// fit: fitTouches() of these touches, 3 to 8 of them. Source: as expectedError_m(), touchingError_m() and
/// likelyMax_m().
ErrorInTheMiddle errorInTheMiddle(const std::vector<Touch>& touches, const Fit& fit);

}  // namespace underact::registration
