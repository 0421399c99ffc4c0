#pragma once
#include <Eigen/Core>

#include "core/lab/transfer_function.h"

namespace underact::lab {

/// The response of a transfer function to a unit step at t = 0 from rest, exact at any time. The poles form a cascade
/// of first-order stages, each with a gain of 1 at rest where its pole is not 0; the response is the exponential of the
/// cascade's matrix, which stays accurate for repeated and widely spread poles where partial fractions do not.
class UnitStep {
 public:
  // One stage for each pole, and the step itself; on the stack, since a search multiplies millions of them.
  static constexpr int kMax = static_cast<int>(kHighestDegree) + 1;
  using Matrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, kMax, kMax>;
  using Vector = Eigen::Matrix<Complex, Eigen::Dynamic, 1, 0, kMax, 1>;
  using Row = Eigen::Matrix<Complex, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMax>;

  /// transfer: of makeTransferFunction(). Finds its poles, as poles() does.
  explicit UnitStep(const TransferFunction& transfer);

  /// y(t), t_s >= 0; at 0 the value just after the step. Not finite where it is beyond a double.
  double at(double t_s) const;

  // Of functions without a pole at 0: the deviation from the final value. stages: what is left of each stage, all 1 at
  // first; times stagesAfter(t) gives them t later.
  Vector stagesAt(double t_s) const { return stagesAfter(t_s).rowwise().sum(); }
  Matrix stagesAfter(double t_s) const;
  /// y - y(infinity).
  double deviation(const Vector& stages) const { return -output_.transpose().cwiseProduct(stages).sum().real(); }
  /// dy/dt.
  double rate(const Vector& stages) const { return rate_output_.transpose().cwiseProduct(stages).sum().real(); }

 private:
  Vector poles_;  // of the stages
  Vector gains_;  // of what goes into each stage
  Row output_;
  Row rate_output_;
  double direct_ = 0.0;  // direct feedthrough
};

}  // namespace underact::lab
