#pragma once
#include <array>

#include "core/extremes/oracle/real.h"

namespace underact::extremes::oracle {

/// A turn and a shift. Turns are unit quaternions: another way than the code's matrices.
struct Quaternion {
  Real w = 1, x = 0, y = 0, z = 0;
};
Quaternion operator*(const Quaternion& a, const Quaternion& b);
Quaternion about(const Real3& unit_axis, const Real& angle);
Real3 turned(const Quaternion& turn, const Real3& v);

struct Motion {
  Quaternion turn;
  Real3 shift{0, 0, 0};
};
Motion operator*(const Motion& a, const Motion& b);
inline Real3 moved(const Motion& motion, const Real3& p) {
  return turned(motion.turn, p) + motion.shift;
}

/// The columns of a matrix in the place of a turn, whatever its rounding.
using Columns = std::array<Real3, 3>;
Columns columnsOf(const Mat3& R);
inline Columns turned(const Quaternion& turn, const Columns& columns) {
  return {turned(turn, columns[0]), turned(turn, columns[1]), turned(turn, columns[2])};
}
Columns columnsOf(const Quaternion& turn);
/// a^T b.
Columns between(const Columns& a, const Columns& b);

/// The angle of the turn from a to b, in [0, pi].
Real angleOf(const Columns& a, const Columns& b);

double ulpsOf(const Mat3& got, const Columns& right, const Real& scale);

}  // namespace underact::extremes::oracle
