#pragma once
#include "core/base/real_time.h"
#include "core/shape/shape.h"
#include "core/target/influence.h"
#include "core/target/target.h"

namespace underact::target {

/// A shape whose nearest point the stylus is held to.
struct NearestOnShape {
  shape::Shape shape;     // in W, or, weighted, with each coordinate of W multiplied by scale
  bool weighted = false;  // nearest in the metric of scale^2, not of lengths
  Vec3 scale = Vec3::Ones();
};

/// A shape whose target depends on the orientation of the stylus, too.
struct InfluencedShape {
  shape::Shape shape;  // in W
  Influence influence = {};
};

/// stiffness: the gains, any unit, whose metric defines the nearest point; all equal: the Euclidean metric. Each must
/// be above 0 unless all are equal or the shape is a point; the scene's check guarantees that.
NearestOnShape nearestOn(const shape::Shape& shape, const Vec3& stiffness);

/// The target for a tip at p_WT, m, finite. Cost: constant for each shape.
/// Source of the weighted metric: errata section 6, a position-only virtual manipulator with W = K.
Target nearestTarget(const NearestOnShape& held, Side side, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

/// The point of the shape nearest to p_W; p_WP, which is on it, where there are several.
Vec3 ontoShape(const NearestOnShape& held, const Vec3& p_W, const Vec3& p_WP) noexcept UNDERACT_REAL_TIME;
Vec3 ontoShape(const InfluencedShape& held, const Vec3& p_W, const Vec3& p_WP) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::target
