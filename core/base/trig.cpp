#include "core/base/trig.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif
#include <sleef.h>

#include "core/base/excepted.h"

namespace underact {

SinCos sinCos(double angle_rad) noexcept {
  const Sleef_double_2 both =
      UNDERACT_EXCEPTED("straight-line code of SLEEF: no lock, no heap", Sleef_cinz_sincosd1_u10purec(angle_rad));
  return {both.x, both.y};
}

SinCosPair sinCosOfTwo(double first_rad, double second_rad) noexcept {
#if defined(__SSE2__)
  const __m128d angles_rad = _mm_set_pd(second_rad, first_rad);
  const Sleef___m128d_2 both =
      UNDERACT_EXCEPTED("straight-line code of SLEEF: no lock, no heap", Sleef_cinz_sincosd2_u10sse2(angles_rad));
  return {{_mm_cvtsd_f64(both.x), _mm_cvtsd_f64(both.y)},
          {_mm_cvtsd_f64(_mm_unpackhi_pd(both.x, both.x)), _mm_cvtsd_f64(_mm_unpackhi_pd(both.y, both.y))}};
#else
  return {sinCos(first_rad), sinCos(second_rad)};
#endif
}

double atan2Of(double y, double x) noexcept {
  return UNDERACT_EXCEPTED("straight-line code of SLEEF: no lock, no heap", Sleef_cinz_atan2d1_u10purec(y, x));
}

AnglePair atan2OfTwo(double first_y, double first_x, double second_y, double second_x) noexcept {
#if defined(__SSE2__)
  const __m128d y = _mm_set_pd(second_y, first_y), x = _mm_set_pd(second_x, first_x);
  __m128d both{};
  UNDERACT_EXCEPTED("straight-line code of SLEEF: no lock, no heap", void(both = Sleef_cinz_atan2d2_u10sse2(y, x)));
  return {_mm_cvtsd_f64(both), _mm_cvtsd_f64(_mm_unpackhi_pd(both, both))};
#else
  return {atan2Of(first_y, first_x), atan2Of(second_y, second_x)};
#endif
}

}  // namespace underact
