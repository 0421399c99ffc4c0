#pragma once
#include "core/base/real_time.h"

namespace underact {

/// The sine and cosine of one angle; those of 0 at first.
struct SinCos {
  double sin = 0.0;
  double cos = 1.0;
};

/// sin and cos of angle_rad, within 1 ulp, bit-identical on every machine: SLEEF's non-FMA forms, since glibc's differ
/// in the last bit between CPUs with and without FMA. Not finite in, NaN out. Cost: constant.
SinCos sinCos(double angle_rad) noexcept UNDERACT_REAL_TIME;

/// sinCos() of two angles in one pass where the processor can (SSE2): the same bits in 0.6 of the time.
struct SinCosPair {
  SinCos first;
  SinCos second;
};
/// Angles in rad, each on its own: one that is not finite leaves the other alone.
SinCosPair sinCosOfTwo(double first_rad, double second_rad) noexcept UNDERACT_REAL_TIME;

/// The angle of (x, y) in (-pi, pi], rad, within 1 ulp, bit-identical on every machine.
double atan2Of(double y, double x) noexcept UNDERACT_REAL_TIME;

/// atan2Of() of two pairs in one pass where the processor can: the same bits.
struct AnglePair {
  double first_rad;
  double second_rad;
};
/// Each pair on its own, as atan2Of().
AnglePair atan2OfTwo(double first_y, double first_x, double second_y, double second_x) noexcept UNDERACT_REAL_TIME;

}  // namespace underact
