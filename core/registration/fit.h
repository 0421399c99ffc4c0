#pragma once
#include <cstddef>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"

namespace underact::registration {

// Where an arm stands on the desk. Frame D: the desk, its origin at the first mark, x to the right, y up, z to the
// person in front of it: the axes of the arm's own frame W where the arm stands straight before that person.

inline constexpr std::size_t kFewestMarks = 3, kMostMarks = 8;

/// A mark on the desk, and where the arm saw its tip while that rested in it.
struct Touch {
  Vec3 p_DM = Vec3::Zero();
  Vec3 p_WM = Vec3::Zero();
  double spread_m = 0.0;  // of the samples about p_WM, root of the mean square; 0: not known
};

/// The pose of the arm on the desk that brings the touched points nearest to their marks.
struct Fit {
  Pose X_DW = Pose::Identity();
  std::vector<Vec3> off_D;  // of each mark: from the mark to where the touched point comes to lie
  double rms_m = 0.0;       // root of the mean square of their lengths
};

/// By least squares, turn and place without scale, never a mirror image.
/// Problems: fewer than 3 marks or more than 8, a number that is not finite, marks or touched points that are the same
/// or lie on one line: then nothing says how the arm is turned about it.
/// Source: Arun, Huang, Blostein 1987; Umeyama 1991 for the mirrored case.
Result<Fit> fitTouches(const std::vector<Touch>& touches);

/// How the marks lie.
struct Layout {
  double off_line_m = 0.0;     // root mean square distance from the line that fits them best
  double least_apart_m = 0.0;  // of the two that are nearest to each other
  std::size_t near_one = 0, near_other = 0;
};
/// points: three at least, finite.
Layout layoutOf(const std::vector<Vec3>& points);

std::vector<Vec3> marksOf(const std::vector<Touch>& touches);    // in D
std::vector<Vec3> touchedOf(const std::vector<Touch>& touches);  // in W

}  // namespace underact::registration
