#pragma once
#include <cmath>
#include <cstdint>

#include "core/base/axis_geometry.h"
#include "core/base/random.h"
#include "core/base/types.h"

namespace underact::error_bounds {

/// Draws difficult inputs: scales of all sizes, directions on and near the axes, positions near degenerate ones. The
/// same numbers on every machine and with every compiler: no library logarithm is involved, and no two of them are
/// drawn in the arguments of one call, whose order is up to the compiler.
class Dice {
 public:
  /// The same seed gives the same draws.
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  /// In [0, 1).
  double share() { return nextShare(state_); }
  /// 0 to count - 1, equally likely. count: above 0.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(share() * static_cast<double>(count)); }
  /// True once in so many draws on average. in: above 0.
  bool one(std::size_t in) { return below(in) == 0; }
  /// In [low, high), up to rounding; equally distributed.
  double between(double low, double high) { return low + (high - low) * share(); }
  /// -1 or +1.
  double sign() { return one(2) ? -1.0 : 1.0; }

  /// 2^low to 2^high, all powers of two equally likely.
  double power(int low, int high) {
    const int exponent = low + static_cast<int>(below(static_cast<std::size_t>(high - low)));
    return std::ldexp(1.0 + share(), exponent);
  }
  /// 1e-12 to 1e12.
  double scale() { return power(-40, 40); }
  /// Close to 1, rarely far from it.
  double ratio() { return one(3) ? power(-20, 20) : between(0.2, 2.0); }
  /// 2^-k, k up to 60, either sign; sometimes 0.
  double closeness() { return one(8) ? 0.0 : sign() * power(-60, 0); }

  /// Three of ratio().
  Vec3 ratios() { return {ratio(), ratio(), ratio()}; }  // in braces they are drawn in their order

  /// Each coordinate in [-half, half).
  Vec3 inBox(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
  /// Unit to a few ulp: along an axis, a little off one, in a plane of two, or anywhere.
  Vec3 direction();
  /// A rotation to a few ulp.
  Mat3 turn();
  /// A position about a centre with an axis: in a box of the given size, on the axis except for 2^-k, at any scale, or
  /// the centre.
  Vec3 pointAbout(const Vec3& middle_W, const Vec3& axis_W, double size);
  /// The same, sometimes with a coordinate that is zero of either sign, or denormal.
  Vec3 oddPointAbout(const Vec3& middle_W, const Vec3& axis_W, double size);
  /// An angle, rad: within a turn, a quarter turn except for 2^-k, or up to 1e6.
  double angle();

 private:
  std::uint64_t state_;
};

/// The seed of a case, a function of seed and index alone.
std::uint64_t caseSeed(std::uint64_t seed, std::uint64_t index);

}  // namespace underact::error_bounds
