#pragma once
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "core/base/denormals.h"
#include "core/base/types.h"

namespace underact::error_bounds {

// Inside the room: numbers of a hundred decimal digits, so that the rounding of an oracle is negligible against an ulp,
// whatever cancels: 1e12 beside 1e-12, squared twice, takes 48 of them.
using Real = boost::multiprecision::cpp_bin_float_100;

/// A vector of such numbers.
struct Real3 {
  Real x, y, z;
};

// The operations of Vec3.
/// The doubles, exactly.
inline Real3 real(const Vec3& v) {
  return {Real(v.x()), Real(v.y()), Real(v.z())};
}
/// a + b.
inline Real3 operator+(const Real3& a, const Real3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
/// a - b.
inline Real3 operator-(const Real3& a, const Real3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// s times v.
inline Real3 operator*(const Real& s, const Real3& v) {
  return {s * v.x, s * v.y, s * v.z};
}
/// The scalar product.
inline Real dot(const Real3& a, const Real3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// The vector product a x b.
inline Real3 cross(const Real3& a, const Real3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The length, without overflow: the exponents of Real are wide enough for squares of doubles.
inline Real norm(const Real3& v) {
  return sqrt(dot(v, v));
}
/// v / |v|; v: not 0.
inline Real3 unit(const Real3& v) {
  return (1 / norm(v)) * v;
}
/// v less its part along the axis.
inline Real3 without(const Real3& v, const Real3& unit_axis) {
  return v - dot(v, unit_axis) * unit_axis;
}
/// value held within [low, high].
inline Real clamped(const Real& value, const Real& low, const Real& high) {
  return value < low ? low : value > high ? high : value;
}
/// Pi, to the digits of Real. Computed at the first call.
inline const Real& piReal() {
  static const Real kPiReal = 4 * atan(Real(1));
  return kPiReal;
}

/// |error| in ulp of scale (2^-52 of it); errors below the smallest normal number count as none.
inline double ulpsOf(const Real& error, const Real& scale) {
  static const Real kUlp = ldexp(Real(1), -52), kMin = ldexp(Real(1), -1022);
  return static_cast<double>(Real(abs(error) / (kUlp * scale + kMin)));
}
inline double ulpsOf(const Vec3& got, const Real3& right, const Real& scale) {
  if (!got.allFinite()) return kInfinity;
  const Real3 off = real(got) - right;
  return ulpsOf(std::max({Real(abs(off.x)), Real(abs(off.y)), Real(abs(off.z))}), scale);
}
inline double ulpsOf(double got, const Real& right, const Real& scale) {
  if (!std::isfinite(got)) return kInfinity;
  return ulpsOf(Real(Real(got) - right), scale);
}

/// The result under the servo's arithmetic, in which denormals are zero. The oracle runs outside of it.
template <class Ask>
auto asTheServo(const Ask& ask) {
  const FlushDenormals flush;
  return ask();
}

}  // namespace underact::error_bounds
