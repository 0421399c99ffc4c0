#pragma once
#include <cstdint>
#include <optional>

#include "core/base/real_time.h"
#include "core/manipulator/manipulator.h"
#include "core/shape/shape.h"
#include "core/target/curve_target.h"
#include "core/target/influence.h"
#include "core/target/mesh_target.h"

namespace underact::target {

/// Both: the stylus is held to the surface. Outside, Inside: where it is free to be; a wall that pushes it back there.
enum class Side : std::uint8_t { Both, Outside, Inside };

/// What the stylus is held to. Made by makeConstraint().
struct Constraint {
  shape::Shape shape;  // in W, or, weighted, with each coordinate of W multiplied by scale
  Side side = Side::Both;
  bool weighted = false;  // nearest in the metric of scale^2, not of lengths
  Vec3 scale = Vec3::Ones();
  bool influenced = false;  // the stylus's turn has a part in the target: influence (both sides, not weighted)
  Influence influence = {};
  std::optional<manipulator::Manipulator> manipulator = {};  // its tip takes the place of the shape
  std::optional<MeshPlace> mesh = {};                        // takes the place of the shape (not weighted)
  std::optional<CurvePath> curve = {};                       // the same
  Friction friction = {};                                    // of a shape, a mesh or a curve
};

/// Free: an untouched wall. Degenerate: several points are equally near, so nothing says where to pull.
enum class Status : std::uint8_t { Unique, Degenerate, Free };

/// Where the constraint draws the tip this tick.
struct Target {
  Vec3 p_WP = Vec3::Zero();  // m; the tip itself unless Unique, so that the error is zero
  Status status = Status::Degenerate;
  double distance_m = 0.0;  // from the shape, in W (Degenerate and weighted: in the metric); 0 for a free wall
  Angles angles = {};       // of an influenced one
  Arc arc = {};             // of an influenced one
};

/// stiffness: the gains, any unit, whose metric decides what is nearest; all equal means the Euclidean metric. Each
/// must be above 0 unless all are equal or the shape is a point; the scene's check sees to that.
Constraint makeConstraint(const shape::Shape& shape, Side side, const Vec3& stiffness);

/// p_WT: m, finite. Cost: constant for each shape.
/// Source of the weighted metric: errata section 6, a position-only virtual manipulator with W = K.
Target nearestTarget(const Constraint& constraint, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

/// Where on the mesh or the curve the target without friction is; null: it is no mesh, no curve.
struct Whereabouts {
  const MeshState* mesh = nullptr;
  const CurveState* curve = nullptr;
};

/// The target without friction -> the one with it: the point where the target holds on to the shape.
Target rubbedTarget(const Constraint& constraint, const Vec3& p_WT, const Target& target, const Whereabouts& where,
                    Grip& grip) noexcept UNDERACT_REAL_TIME;

/// The same for an influenced constraint; stylus_W: z of frame 6, unit; dt_s: since the last one, 0: unknown.
Target influencedTarget(const Constraint& constraint, const Vec3& p_WT, const Vec3& stylus_W, double dt_s,
                        InfluenceState& state) noexcept UNDERACT_REAL_TIME;

/// "unique", "degenerate", "free": the words of the command line.
const char* name(Status status);

}  // namespace underact::target
