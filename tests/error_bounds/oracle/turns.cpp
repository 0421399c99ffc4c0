#include "tests/error_bounds/oracle/turns.h"

namespace underact::error_bounds::oracle {

Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Quaternion about(const Real3& unit_axis, const Real& angle) {
  const Real s = sin(Real(angle / 2));
  return {cos(Real(angle / 2)), s * unit_axis.x, s * unit_axis.y, s * unit_axis.z};
}

Real3 turned(const Quaternion& turn, const Real3& v) {
  const Real3 u{turn.x, turn.y, turn.z}, twice = Real(2) * cross(u, v);
  return v + turn.w * twice + cross(u, twice);
}

Motion operator*(const Motion& a, const Motion& b) {
  return {a.turn * b.turn, turned(a.turn, b.shift) + a.shift};
}

Columns columnsOf(const Mat3& R) {
  return {real(R.col(0)), real(R.col(1)), real(R.col(2))};
}

Columns columnsOf(const Quaternion& turn) {
  return turned(turn, Columns{Real3{1, 0, 0}, Real3{0, 1, 0}, Real3{0, 0, 1}});
}

Columns between(const Columns& a, const Columns& b) {
  Columns result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = {dot(a[0], b[i]), dot(a[1], b[i]), dot(a[2], b[i])};
  return result;
}

Real angleOf(const Columns& a, const Columns& b) {
  const Columns r = between(a, b);
  const Real3 twice_sine{r[1].z - r[2].y, r[2].x - r[0].z, r[0].y - r[1].x};
  return atan2(norm(twice_sine), Real(r[0].x + r[1].y + r[2].z - 1));
}

double ulpsOf(const Mat3& got, const Columns& right, const Real& scale) {
  double worst = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    worst = std::max(worst, error_bounds::ulpsOf(Vec3(got.col(static_cast<Eigen::Index>(i))), right[i], scale));
  return worst;
}

}  // namespace underact::error_bounds::oracle
