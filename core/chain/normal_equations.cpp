#include "core/chain/normal_equations.h"

#include <array>

#include "core/base/linear_system.h"

namespace underact::chain {
namespace {

using System = SymmetricSystem<6>;

/// The columns of the free joints, without gaps.
struct Columns {
  std::array<std::array<double, 6>, kMaxJoints> column{};
  std::array<Eigen::Index, kMaxJoints> joint{};
  std::size_t count = 0;
};

Columns freeColumns(const Jacobian& J, std::uint32_t held) noexcept {
  Columns free;
  for (Eigen::Index i = 0; i < J.cols(); ++i) {
    if ((held >> static_cast<unsigned>(i) & 1U) != 0U) continue;
    for (std::size_t k = 0; k < 6; ++k) free.column[free.count][k] = J(static_cast<Eigen::Index>(k), i);
    free.joint[free.count++] = i;
  }
  return free;
}

/// (J^T J + damping) x = J^T e: x is the step.
System overJoints(const Columns& free, const Residual& e, std::size_t rows, double damping) noexcept {
  System s;
  s.size = free.count;
  for (std::size_t i = 0; i < s.size; ++i) {
    s.b[i] = 0.0;
    for (std::size_t k = 0; k < rows; ++k) s.b[i] += free.column[i][k] * e[static_cast<Eigen::Index>(k)];
    for (std::size_t j = 0; j <= i; ++j) {
      s.a[i][j] = 0.0;
      for (std::size_t k = 0; k < rows; ++k) s.a[i][j] += free.column[i][k] * free.column[j][k];
    }
    s.a[i][i] += damping;
  }
  return s;
}

/// (J J^T + damping) x = e: J^T x is the step.
System overRows(const Columns& free, const Residual& e, std::size_t rows, double damping) noexcept {
  System s;
  s.size = rows;
  for (std::size_t i = 0; i < rows; ++i) {
    s.b[i] = e[static_cast<Eigen::Index>(i)];
    for (std::size_t j = 0; j <= i; ++j) {
      s.a[i][j] = 0.0;
      for (std::size_t k = 0; k < free.count; ++k) s.a[i][j] += free.column[k][i] * free.column[k][j];
    }
    s.a[i][i] += damping;
  }
  return s;
}

}  // namespace

bool dampedStep(const Jacobian& J, const Residual& e, std::size_t rows, double damping, std::uint32_t held,
                JointStep& dq) noexcept {
  const Columns free = freeColumns(J, held);
  const bool few = free.count <= rows;
  System s = few ? overJoints(free, e, rows, damping) : overRows(free, e, rows, damping);
  dq.setZero();
  if (!solveInPlace(s)) return false;
  for (std::size_t i = 0; i < free.count; ++i) {
    double& step = dq[free.joint[i]];
    if (few) {
      step = s.b[i];
    } else {
      for (std::size_t k = 0; k < rows; ++k) step += free.column[i][k] * s.b[k];
    }
  }
  return true;
}

}  // namespace underact::chain
