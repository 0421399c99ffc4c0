#include "tests/error_bounds/dice.h"

#include <Eigen/Geometry>
#include <array>

#include "core/base/units.h"

namespace underact::error_bounds {

Vec3 Dice::direction() {
  const auto unit = [this] { return Vec3(sign() * Vec3::Unit(static_cast<Eigen::Index>(below(3)))); };
  switch (below(6)) {
    case 0:
      return unit();
    case 1:
      return Vec3(unit() + closeness() * Vec3::Unit(static_cast<Eigen::Index>(below(3)))).normalized();
    case 2: {
      const double share_of = between(-1.0, 1.0);
      return Vec3(share_of * Vec3::UnitX() + std::sqrt(1.0 - share_of * share_of) * Vec3::UnitZ());
    }
    default:
      break;
  }
  for (;;) {
    const Vec3 v = inBox(1.0);
    if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
  }
}

Mat3 Dice::turn() {
  const Vec3 z_W = direction(), x_W = referencePerpendicular(z_W);
  Mat3 R;
  R << x_W, z_W.cross(x_W), z_W;
  if (one(3)) return R;
  return R * Eigen::Quaterniond(std::sqrt(0.5), std::sqrt(0.5) * share(), 0.0, 0.0).normalized().toRotationMatrix();
}

Vec3 Dice::pointAbout(const Vec3& middle_W, const Vec3& axis_W, double size) {
  switch (below(8)) {
    case 0:
      return inBox(scale());
    case 1:
      return middle_W + inBox(scale());
    case 2:
      return middle_W;
    case 3:
    case 4: {
      const double along = one(2) ? 0.0 : size * between(-2.0, 2.0);
      return middle_W + along * axis_W + (size * closeness()) * referencePerpendicular(axis_W);
    }
    default:
      return middle_W + inBox(2.0 * size);
  }
}

Vec3 Dice::oddPointAbout(const Vec3& middle_W, const Vec3& axis_W, double size) {
  constexpr std::array<double, 6> kOdd{0.0, -0.0, 5e-324, -5e-324, 1e-310, -1e-308};
  Vec3 place_W = pointAbout(middle_W, axis_W, size);
  if (one(8)) place_W[static_cast<Eigen::Index>(below(3))] = kOdd[below(kOdd.size())];
  return place_W;
}

double Dice::angle() {
  switch (below(6)) {
    case 0:
      return static_cast<double>(below(9)) * (0.5 * kPi) - 2.0 * kPi + closeness();
    case 1:
      return sign() * power(-60, 0);
    case 2:
      return one(4) ? sign() * power(0, 20) : 0.0;
    default:
      return between(-2.0 * kPi, 2.0 * kPi);
  }
}

std::uint64_t caseSeed(std::uint64_t seed, std::uint64_t index) {
  std::uint64_t state = seed ^ (index * 0xD1B54A32D192ED03U + 0x8CB92BA72F3D8DD7U);
  nextShare(state);
  std::uint64_t z = state ^ (state >> 29U);
  nextShare(z);
  return z;
}

}  // namespace underact::error_bounds
