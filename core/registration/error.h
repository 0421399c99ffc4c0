#pragma once
#include <cstddef>
#include <vector>

#include "core/base/types.h"
#include "core/registration/fit.h"

namespace underact::registration {

/// How far off a touched point is expected to be, m, root of the mean square of its distance from the mark, from what
/// the fit leaves over: rms sqrt(N / (N - 2)), for the fit takes a part of the error up.
/// Source: Fitzpatrick, West, Maurer 1998, eq. 10. marks: 3 at least.
double touchingError_m(double rms_m, std::size_t marks);

/// The same, as it is or less in 19 of 20 registrations: 3N - 6 squares are few. Source: chi-square, 5 %. marks: 3
/// to 8.
double likelyMost_m(double rms_m, std::size_t marks);

/// How far off a point of the desk is expected to be, m, root of the mean square, where each mark was touched with that
/// error: e^2 / N (1 + (d1^2 / f1^2 + d2^2 / f2^2 + d3^2 / f3^2) / 3), d the point's and f the marks' root mean square
/// distance from each principal axis of the marks. marks_D: as fitTouches() takes them.
/// Source: Fitzpatrick, West, Maurer 1998, eq. 46.
double expectedError_m(const std::vector<Vec3>& marks_D, double touching_m, const Vec3& p_D);

/// The expected error at the middle of the workspace, p_W = 0, m.
struct ErrorInTheMiddle {
  double expected_m = 0.0;
  double likely_most_m = 0.0;  // expected, of likelyMost_m()
};
/// fit: fitTouches() of these touches, 3 to 8 of them. Source: expectedError_m() and its two arguments.
ErrorInTheMiddle errorInTheMiddle(const std::vector<Touch>& touches, const Fit& fit);

}  // namespace underact::registration
