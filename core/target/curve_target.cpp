#include "core/target/curve_target.h"

#include "core/base/valid_bytes.h"

namespace underact::target {

bool isValid(const CurveState& state, const curve::Curve& curve) noexcept {
  const std::int32_t piece = state.search.piece;
  return piece >= -1 && piece < pieceCount(curve) && isFlag(state.guide.begun);
}

Target curveTarget(const CurvePath& path, const Vec3& p_WT, double dt_s, CurveState& state) noexcept {
  const curve::Nearest nearest = nearestPoint(*path.curve, path.search, p_WT, state.search);
  const curve::GuidedTarget guided = guidedTarget(*path.curve, path.guide, nearest, p_WT, dt_s, state.guide);
  return {guided.p_WP, Status::Unique, nearest.distance_m};
}

Vec3 ontoCurve(const CurvePath& path, const CurveState& state, const Vec3& p_W) noexcept {
  curve::SearchState search = state.search;
  return nearestPoint(*path.curve, Search::Local, p_W, search).p_WP;
}

}  // namespace underact::target
