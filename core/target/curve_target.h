#pragma once
#include <memory>

#include "core/base/real_time.h"
#include "core/curve/guidance.h"
#include "core/curve/nearest.h"
#include "core/target/target.h"

namespace underact::target {

/// A curve that the stylus is held to, with guidance along it where there is any.
struct CurvePath {
  std::shared_ptr<const curve::Curve> curve;  // in W; never null
  Search search = Search::Hybrid;
  curve::Guidance guide = {};
};

/// What a curve remembers from tick to tick.
struct CurveState {
  curve::SearchState search;
  curve::GuidanceState guide;
};

/// For bytes from a file: whether the state can be used. curve: for which it was made.
bool isValid(const CurveState& state, const curve::Curve& curve) noexcept;

/// The target of the guidance; without it the nearest point of the curve. dt_s: since the last tick, 0: unknown. Where
/// two points far apart are equally near it is the one of the last tick, so it is never degenerate.
Target curveTarget(const CurvePath& path, const Vec3& p_WT, double dt_s, CurveState& state) noexcept UNDERACT_REAL_TIME;

/// The point of the curve near p_W, found along it from the target.
Vec3 ontoCurve(const CurvePath& path, const CurveState& state, const Vec3& p_W) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::target
