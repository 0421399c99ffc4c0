#include <array>

#include "core/base/linear_system.h"
#include "core/base/rotation.h"
#include "core/base/trig.h"
#include "tests/error_bounds/oracle/turns.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace base_rows {

/// The error in ulp of the value itself, or of the smallest normal number for values below it.
double ownUlps(double got, const Real& right) {
  return ulpsOf(got, right, Real(abs(right)));
}

Outcome judgeSinCos(Input& input) {
  const double angle_rad = input.number(
      "angle_rad", [](Dice& dice) { return dice.one(4) ? dice.sign() * dice.power(-1000, 40) : dice.angle(); });
  const auto [one, two] = asTheServo([&] { return sinCosOfTwo(angle_rad, -angle_rad); });
  const SinCos alone = asTheServo([&] { return sinCos(angle_rad); });
  const bool same = alone.sin == one.sin && alone.cos == one.cos && two.cos == one.cos && two.sin == -one.sin;
  if (!same) return {kInfinity, false};
  return {std::max(ownUlps(alone.sin, sin(Real(angle_rad))), ownUlps(alone.cos, cos(Real(angle_rad)))), false};
}

Outcome judgeAtan2(Input& input) {
  const auto draw = [](Dice& dice) {
    return dice.one(8) ? dice.sign() * 0.0 : dice.sign() * (dice.one(3) ? dice.power(-900, 900) : dice.scale());
  };
  const double y = input.number("y", draw), x = input.number("x", draw);
  const double got_rad = asTheServo([&] { return atan2Of(y, x); });
  if (y == 0.0) {  // the sign of zero counts: half a turn either way
    const double right_rad = std::signbit(x) ? std::copysign(kPi, y) : y;
    return {got_rad == right_rad ? 0.0 : kInfinity, false};
  }
  return {ownUlps(got_rad, atan2(Real(y), Real(x))), false};
}

Outcome judgeRotationVector(Input& input) {
  const Vec3 axis = input.vector("axis", [](Dice& dice) { return dice.direction(); });
  const double angle_rad = input.number("angle_rad", [](Dice& dice) {
    return dice.one(2) ? dice.between(0.0, kPi) : dice.one(2) ? std::abs(dice.closeness()) : kPi - dice.power(-60, -1);
  });
  const Mat3 R = Eigen::AngleAxisd(angle_rad, axis.normalized()).toRotationMatrix();
  const Vec3 got = asTheServo([&] { return rotationVector(R); });
  if (!got.allFinite()) return {kInfinity, false};
  // Judged by the rotation that results: at half a turn two vectors are right.
  const Real3 vector = real(got);
  const Real length = norm(vector);
  if (length == 0) return {oracle::ulpsOf(R, oracle::columnsOf(oracle::Quaternion{}), piReal()), false};
  return {oracle::ulpsOf(R, oracle::columnsOf(oracle::about(unit(vector), length)), piReal()), false};
}

/// L D L^T and its right side by the residual of the result: backward stable, whatever the condition.
Outcome judgeSystem(Input& input) {
  constexpr std::size_t kMax = 8;
  const std::size_t size = 1 + input.choice("size", kMax);
  const double unit = input.number("unit", [](Dice& dice) { return dice.scale(); });
  std::array<std::array<double, kMax>, kMax> root{};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j <= i; ++j)
      root[i][j] = input.number("a", [&](Dice& dice) { return unit * (i == j ? dice.ratio() : dice.between(-1, 1)); });
  }
  SymmetricSystem<kMax> system;
  system.size = size;
  Real largest = 0;
  std::array<std::array<Real, kMax>, kMax> a;
  std::array<Real, kMax> b;
  for (std::size_t i = 0; i < size; ++i) {
    system.b[i] = input.number("b", [](Dice& dice) { return dice.between(-1, 1); });
    b[i] = system.b[i];
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0.0;
      for (std::size_t k = 0; k <= j; ++k) sum += root[i][k] * root[j][k];
      system.a[i][j] = sum;
      a[i][j] = a[j][i] = sum;
      largest = std::max(largest, Real(abs(a[i][j])));
    }
  }
  const bool solved = asTheServo([&] { return solveInPlace(system); });
  if (!solved) return {0.0, true};  // rounding has left nothing of a pivot
  Real answer = 0, worst = 0, right = 0;
  for (std::size_t i = 0; i < size; ++i) answer = std::max(answer, Real(abs(Real(system.b[i]))));
  for (std::size_t i = 0; i < size; ++i) {
    if (!std::isfinite(system.b[i])) return {kInfinity, false};
    Real residual = -b[i];
    for (std::size_t j = 0; j < size; ++j) residual += a[i][j] * system.b[j];
    worst = std::max(worst, Real(abs(residual)));
    right = std::max(right, Real(abs(b[i])));
  }
  return {ulpsOf(worst, largest * answer + right), false};
}

constexpr std::array<Row, 4> kRows{{
    {"sin_cos", Kind::Base, "Sine and cosine, up to 1e12 rad", "ulp of the value; one and two at a time the same bits",
     1, 1, judgeSinCos},
    {"atan2", Kind::Base, "Angle of (x, y)", "ulp of the value", 1, 1, judgeAtan2},
    {"rotation_vector", Kind::Base, "Logarithm of a rotation", "ulp of pi: of the matrix that the vector gives back", 4,
     1, judgeRotationVector},
    {"linear_system", Kind::Base, "Symmetric system of 1 to 8 unknowns",
     "ulp of |a| |x| + |b|: the residual, whatever the condition", 64, 1, judgeSystem},
}};

}  // namespace base_rows

constinit const std::span<const Row> kBaseRows = base_rows::kRows;

}  // namespace underact::error_bounds
