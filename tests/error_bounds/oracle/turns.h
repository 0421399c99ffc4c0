#pragma once
#include <array>

#include "tests/error_bounds/oracle/real.h"

namespace underact::error_bounds::oracle {

/// A rotation as a unit quaternion: a different representation from the code's matrices.
struct Quaternion {
  Real w = 1, x = 0, y = 0, z = 0;
};
// Quaternions are taken as unit; angles in rad.
/// b first, then a.
Quaternion operator*(const Quaternion& a, const Quaternion& b);
/// The rotation about an axis of length 1.
Quaternion about(const Real3& unit_axis, const Real& angle);
/// v rotated.
Real3 turned(const Quaternion& turn, const Real3& v);

/// A rotation and then a shift.
struct Motion {
  Quaternion turn;
  Real3 shift{0, 0, 0};
};
/// b first, then a.
Motion operator*(const Motion& a, const Motion& b);
/// Where a point comes to.
inline Real3 moved(const Motion& motion, const Real3& p) {
  return turned(motion.turn, p) + motion.shift;
}

/// The columns of a rotation matrix, whatever its rounding.
using Columns = std::array<Real3, 3>;
/// The doubles, exactly.
Columns columnsOf(const Mat3& R);
/// Each column rotated.
inline Columns turned(const Quaternion& turn, const Columns& columns) {
  return {turned(turn, columns[0]), turned(turn, columns[1]), turned(turn, columns[2])};
}
/// The matrix of the rotation.
Columns columnsOf(const Quaternion& turn);
/// a^T b.
Columns between(const Columns& a, const Columns& b);

/// The angle of the rotation from a to b, in [0, pi].
Real angleOf(const Columns& a, const Columns& b);

/// The worst column by error_bounds::ulpsOf(); infinite where a number is not finite.
double ulpsOf(const Mat3& got, const Columns& right, const Real& scale);

}  // namespace underact::error_bounds::oracle
