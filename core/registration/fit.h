#pragma once
#include <cstddef>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"

namespace underact::registration {

// Where an arm stands on the desk. Frame D: the desk, its origin at the first reference point, x to the right, y up, z
// towards the person in front of it: parallel to the arm's own frame W where the arm stands straight before that
// person.

inline constexpr std::size_t kFewestMarks = 3, kMaxMarks = 8;

/// A reference point on the desk, and where the arm measured its tip while that rested on it.
struct Touch {
  Vec3 p_DM = Vec3::Zero();
  Vec3 p_WM = Vec3::Zero();
  double spread_m = 0.0;  // of the samples about p_WM, root mean square; 0: unknown
};

/// The pose of the arm on the desk that brings the touched points nearest to the reference points.
struct Fit {
  Pose X_DW = Pose::Identity();
  std::vector<Vec3> off_D;  // for each reference point: from it to the touched point
  double rms_m = 0.0;       // root of the mean square of their lengths
};

/// By least squares, rotation and translation without scale, never a mirror image.
/// Problems: fewer than 3 reference points or more than 8, a number that is not finite, reference points or touched
/// points that coincide or lie on one line: then the rotation about it is undetermined.
/// Source: Arun, Huang, Blostein 1987; Umeyama 1991 for the mirrored case.
Result<Fit> fitTouches(const std::vector<Touch>& touches);

/// The arrangement of the reference points.
struct Layout {
  double off_line_m = 0.0;   // root mean square distance from the line that fits them best
  double min_apart_m = 0.0;  // of the two that are nearest to each other
  std::size_t near_one = 0, near_other = 0;
};
/// points: three at least, finite.
Layout layoutOf(const std::vector<Vec3>& points);

std::vector<Vec3> referencePointsOf(const std::vector<Touch>& touches);  // in D
std::vector<Vec3> touchedOf(const std::vector<Touch>& touches);          // in W

}  // namespace underact::registration
