#include "tests/error_bounds/oracle/arm.h"

namespace underact::error_bounds::oracle {
namespace {

const Real3 kX{1, 0, 0}, kZ{0, 0, 1};

Real tiny() {
  return ldexp(Real(1), -110);  // its square is 1e-66
}

/// Craig's row: Rx(alpha) Dx(a) Rz(theta) Dz(d). quarters: of a turn, alpha.
Motion row(int quarters, const Real& a, const Real& theta, const Real& d) {
  const Motion twist{about(kX, quarters * piReal() / 2), {a, 0, 0}}, turn{about(kZ, theta), {0, 0, 0}};
  return twist * turn * Motion{Quaternion{}, {0, 0, d}};
}

template <class At>
auto difference(const At& at, std::array<Real, 6> q, std::size_t joint) {
  const Real middle = q[joint];
  q[joint] = middle + tiny();
  const auto after = at(q);
  q[joint] = middle - tiny();
  return std::pair(at(q), after);
}

}  // namespace

std::array<Real, 6> realOf(const arm::JointAngles& q_rad) {
  return {q_rad[0], q_rad[1], q_rad[2], q_rad[3], q_rad[4], q_rad[5]};
}

ArmPose armPose(const arm::Geometry& geometry, const std::array<Real, 6>& q) {
  // Thesis table 3.1 as corrected: twists 0, 90, 0, 90, -90, 90 degrees, a_2 and d_4 the lengths.
  const Motion in_base = row(0, 0, q[0], 0) * row(1, 0, q[1], 0) * row(0, geometry.upper_m, q[2], 0) *
                         row(1, 0, q[3], geometry.fore_m) * row(-1, 0, q[4], 0) * row(1, 0, q[5], 0);
  const auto inWorkspace = [](const Real3& v) { return Real3{v.y, v.z, v.x}; };  // eq. 3.1
  const Columns R_B = columnsOf(in_base.turn);
  return {{inWorkspace(R_B[0]), inWorkspace(R_B[1]), inWorkspace(R_B[2])},
          real(geometry.p_WB) + inWorkspace(in_base.shift)};
}

std::array<Real3, 3> armJacobian(const arm::Geometry& geometry, const arm::JointAngles& q_rad) {
  std::array<Real3, 3> columns;
  for (std::size_t joint = 0; joint < 3; ++joint) {
    const auto [before, after] = difference([&](const auto& q) { return armPose(geometry, q); }, realOf(q_rad), joint);
    columns[joint] = (1 / (2 * tiny())) * (after.p_WT - before.p_WT);
  }
  return columns;
}

std::array<Real3, 6> armTurning(const arm::Geometry& geometry, const arm::JointAngles& q_rad) {
  std::array<Real3, 6> axes;
  for (std::size_t joint = 0; joint < 6; ++joint) {
    const auto [before, after] = difference([&](const auto& q) { return armPose(geometry, q); }, realOf(q_rad), joint);
    // R_after R_before^T is I + 2 tiny [w]: w is half the sum of the cross products of the columns.
    Real3 sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) sum = sum + cross(before.R_WT[i], after.R_WT[i]);
    axes[joint] = (1 / (4 * tiny())) * sum;
  }
  return axes;
}

Real3 solved(const std::array<Real3, 3>& columns, const Real3& right) {
  const Real whole = dot(columns[0], cross(columns[1], columns[2]));
  return {dot(right, cross(columns[1], columns[2])) / whole, dot(columns[0], cross(right, columns[2])) / whole,
          dot(columns[0], cross(columns[1], right)) / whole};
}

}  // namespace underact::error_bounds::oracle
