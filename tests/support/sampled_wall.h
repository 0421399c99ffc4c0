#pragma once
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "core/base/types.h"

namespace underact::test {

/// A mass in a hand, and a wall that is felt through samples.
struct SampledWall {
  double mass_kg = 0.1;
  double damping_N_s_per_m = 1.0;
  double stiffness_N_per_m = 0.0;  // of the hand
  double kd_N_s_per_m = 0.0;       // B of the wall, by raw difference
  double period_s = 1e-3;
  int delay_ticks = 0;
};

/// The greatest eigenvalue, in size, of what a period makes of the state (x, v, the last x, the forces under way),
/// under F = -(K x + B dx / T) held over a period. Exact: the motion between samples by the exponential of its matrix.
inline double spectralRadius(const SampledWall& wall, double stiffness_N_per_m) {
  Mat3 motion = Mat3::Zero();  // of x, v, F
  motion(0, 1) = 1.0;
  motion(1, 0) = -wall.stiffness_N_per_m / wall.mass_kg;
  motion(1, 1) = -wall.damping_N_s_per_m / wall.mass_kg;
  motion(1, 2) = 1.0 / wall.mass_kg;
  Mat3 period = Mat3::Identity(), term = Mat3::Identity();
  for (int n = 1; n < 20; ++n) {  // of a 1024th of the period, then squared ten times
    term = term * motion * (wall.period_s / 1024.0 / n);
    period += term;
  }
  for (int n = 0; n < 10; ++n) period = period * period;
  const Eigen::Index size = 3 + wall.delay_ticks;
  Eigen::MatrixXd step = Eigen::MatrixXd::Zero(size, size);
  Eigen::RowVectorXd asked = Eigen::RowVectorXd::Zero(size);
  asked[0] = -stiffness_N_per_m - wall.kd_N_s_per_m / wall.period_s;
  asked[2] = wall.kd_N_s_per_m / wall.period_s;
  Eigen::RowVectorXd acting = asked;
  if (wall.delay_ticks > 0) {
    acting.setZero();
    acting[size - 1] = 1.0;
  }
  step.topLeftCorner(2, 2) = period.topLeftCorner<2, 2>();
  step.topRows(2) += period.block<2, 1>(0, 2) * acting;
  step(2, 0) = 1.0;
  if (wall.delay_ticks > 0) step.row(3) = asked;
  for (Eigen::Index n = 4; n < size; ++n) step(n, n - 1) = 1.0;
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

/// The greatest stiffness for which it stays calm, N/m.
inline double exactLimit(const SampledWall& wall) {
  double calm = 0.0, wild = 1e6;
  for (int n = 0; n < 60; ++n) {
    const double middle = 0.5 * (calm + wild);
    (spectralRadius(wall, middle) < 1.0 ? calm : wild) = middle;
  }
  return calm;
}

}  // namespace underact::test
