#include "core/target/influence.h"

#include <array>

#include "core/base/norms.h"
#include "core/target/friction.h"
#include "tests/error_bounds/oracle/shapes.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace influence_rows {

using target::Influence;
using target::Influenced;

struct Drawn {
  Vec3 p_WC, axis_W, p_WT, stylus_W;
  double radius_m = 0.0;
  Influence influence;
};

Drawn drawInfluence(Input& input) {
  Drawn drawn;
  drawn.radius_m = input.number("radius_m", [](Dice& dice) { return dice.scale(); });
  drawn.p_WC = input.vector(
      "p_WC", [&](Dice& dice) { return dice.one(2) ? Vec3(Vec3::Zero()) : dice.inBox(drawn.radius_m * dice.ratio()); });
  drawn.axis_W = input.vector("axis_W", [](Dice& dice) { return dice.direction(); });
  drawn.p_WT =
      input.vector("p_WT", [&](Dice& dice) { return dice.oddPointAbout(drawn.p_WC, drawn.axis_W, drawn.radius_m); });
  drawn.stylus_W = input.vector("stylus_W", [&](Dice& dice) -> Vec3 {
    if (dice.one(3))
      return Vec3(dice.sign() * drawn.axis_W + dice.closeness() * referencePerpendicular(drawn.axis_W)).normalized();
    if (dice.one(3)) return Vec3(dice.sign() * (drawn.p_WT - drawn.p_WC) + 1e-300 * Vec3::UnitX()).stableNormalized();
    return dice.direction();
  });
  drawn.influence.t =
      input.number("t", [](Dice& dice) { return dice.one(4) ? (dice.one(2) ? 0.0 : 1.0) : dice.share(); });
  drawn.influence.stylus_sign = input.flag("minus_z") ? -1.0 : 1.0;
  drawn.influence.blend_rad =
      input.number("blend_rad", [](Dice& dice) { return dice.one(3) ? 0.0 : 0.52 * dice.share(); });
  return drawn;
}

Influenced ask(const Drawn& drawn, const shape::Shape& shape) {
  target::InfluenceState state;
  return asTheServo([&] { return influencedTarget(shape, drawn.influence, drawn.p_WT, drawn.stylus_W, 0.0, state); });
}

Real smooth(const Real& share) {
  const Real x = clamped(share, 0, 1);
  return x * x * (3 - 2 * x);
}

/// The target on the ring about the axis through the tip's foot, by angles: theta = alpha + t wrap(beta - alpha), with
/// the weight of the stylus fading along the axis. lost: the uncertainty of a direction.
struct OnRing {
  Real3 direction;
  Real lost = 0;         // uncertainty of the direction, ulp
  bool is_tie = false;   // half a turn apart: either sense
  bool is_known = true;  // false: near what the code calls degenerate
};
OnRing onRing(const Drawn& drawn, const Vec3& unit_axis_W) {
  const Real3 axis = unit(real(unit_axis_W)), away = real(drawn.p_WT) - real(drawn.p_WC);
  const Real3 stylus = Real(drawn.influence.stylus_sign) * real(drawn.stylus_W);
  const Real3 tip = without(away, axis), turned = without(stylus, axis);
  const Real off = norm(tip), across = norm(turned);
  OnRing ring;
  const Real coarse = ldexp(Real(std::max(largestOf(drawn.p_WC), largestOf(drawn.p_WT))), -46) + 1e-149;
  ring.is_known = off > coarse && across > ldexp(Real(1), -46);
  if (!ring.is_known) return ring;
  Real weight = 1;
  if (drawn.influence.blend_rad > 0.0)
    weight = smooth(Real(atan2(across, Real(abs(dot(stylus, axis))))) / drawn.influence.blend_rad);
  const Real3 u = unit(tip), v = cross(axis, u);
  const Real alpha = atan2(dot(turned, v), dot(turned, u));  // from the tip's direction
  ring.is_tie = abs(alpha) > piReal() - ldexp(norm(away) / off + 1 / across, -48);
  const Real theta = alpha * weight * (1 - Real(drawn.influence.t));
  ring.direction = Real(cos(theta)) * u + Real(sin(theta)) * v;
  // The blend turns an error of the stylus's angle into one of the weight, at most 1.5 / blend of it.
  const Real blend = drawn.influence.blend_rad > 0.0 ? Real(abs(alpha) * 2 / drawn.influence.blend_rad) : Real(0);
  ring.lost = 1 + norm(away) / off + 1 / across + (weight < 1 ? blend : Real(0));
  return ring;
}

Outcome compareRing(const Drawn& drawn, const Influenced& got, const OnRing& ring, const Real3& middle) {
  if (!got.p_WP.allFinite() || !std::isfinite(got.distance_m)) return {kInfinity, false};
  if (!ring.is_known || ring.is_tie) return {0.0, true};
  if (!got.is_unique) return {kInfinity, false};
  const Real scale = Real(std::max(largestOf(drawn.p_WC), largestOf(drawn.p_WT))) + drawn.radius_m * ring.lost;
  return {ulpsOf(got.p_WP, middle + Real(drawn.radius_m) * ring.direction, scale), false};
}

Outcome judgeCircle(Input& input) {
  const Drawn drawn = drawInfluence(input);
  const shape::Circle circle = shape::makeCircle(drawn.p_WC, drawn.axis_W, drawn.radius_m, {}).value();
  return compareRing(drawn, ask(drawn, circle), onRing(drawn, circle.axis_W), real(drawn.p_WC));
}

Outcome judgeCylinder(Input& input) {
  const Drawn drawn = drawInfluence(input);
  const shape::Cylinder cylinder = shape::makeCylinder(drawn.p_WC, drawn.axis_W, drawn.radius_m, {}).value();
  const Real3 foot = oracle::onLine(real(drawn.p_WC), real(cylinder.axis_W), real(drawn.p_WT)).p_WP;
  return compareRing(drawn, ask(drawn, cylinder), onRing(drawn, cylinder.axis_W), foot);
}

Outcome judgeSphere(Input& input) {
  const Drawn drawn = drawInfluence(input);
  const Influenced got = ask(drawn, shape::makeSphere(drawn.p_WC, drawn.radius_m, {}).value());
  if (!got.p_WP.allFinite() || !std::isfinite(got.distance_m)) return {kInfinity, false};
  const Real3 away = real(drawn.p_WT) - real(drawn.p_WC);
  const Real3 from = unit(Real(drawn.influence.stylus_sign) * real(drawn.stylus_W));
  const Real off = norm(away), largest = std::max(largestOf(drawn.p_WC), largestOf(drawn.p_WT));
  if (off <= ldexp(largest, -46) + 1e-149) return {0.0, true};
  const Real3 to = unit(away), normal = cross(from, to);
  const Real sine = norm(normal), angle = atan2(sine, dot(from, to));
  if (sine <= ldexp(Real(1), -46)) {  // one direction, or any great circle from one to the other
    if (dot(from, to) > 0)
      return {ulpsOf(got.p_WP, real(drawn.p_WC) + Real(drawn.radius_m) * to, largest + 64 * drawn.radius_m), false};
    return {0.0, true};
  }
  const Real theta = Real(drawn.influence.t) * angle;
  const Real3 ahead = unit(without(to, from));
  const Real3 direction = Real(cos(theta)) * from + Real(sin(theta)) * ahead;
  // Near half a turn rounding decides the great circle.
  const Real lost = dot(from, to) > 0 ? Real(1) : Real(1 / sine);
  return {ulpsOf(got.p_WP, real(drawn.p_WC) + Real(drawn.radius_m) * direction, largest + drawn.radius_m * lost),
          false};
}

Outcome judgeGrip(Input& input) {
  const double size_m = input.number("size_m", [](Dice& dice) { return dice.scale(); });
  target::Friction friction;
  friction.static_share =
      input.number("static", [](Dice& dice) { return dice.one(3) ? dice.scale() : dice.between(0.01, 2); });
  friction.dynamic_share = input.number("dynamic", [&](Dice& dice) { return friction.static_share * dice.share(); });
  const Vec3 p_WP = input.vector("p_WP", [&](Dice& dice) { return dice.inBox(size_m * dice.ratio()); });
  const Vec3 p_WT =
      input.vector("p_WT", [&](Dice& dice) { return Vec3(p_WP + size_m * dice.closeness() * dice.direction()); });
  const target::Grip before{
      target::Hold::Sticks, 0, 0, 0.0F, input.vector("p_WG", [&](Dice& dice) {
        return Vec3(p_WP + size_m * (dice.one(2) ? dice.ratio() : dice.closeness()) * dice.direction());
      })};
  const Real3 along = real(before.p_WG) - real(p_WP);
  const Real heading = norm(along), depth = norm(real(p_WP) - real(p_WT));
  // What sticks lets go at the static share; what slides lags by the dynamic one.
  bool moved = false;
  target::Grip grip;
  for (const target::Hold hold : {target::Hold::Sticks, target::Hold::Slides}) {
    grip = before;
    grip.hold = hold;
    moved = asTheServo([&] { return slides(friction, p_WT, p_WP, 1e-3, grip); });
    const double share = hold == target::Hold::Sticks ? friction.static_share : friction.dynamic_share;
    const Real held = Real(share) * depth;
    const Real edge = ldexp(Real(heading + held), -48) + ldexp(Real(1), -500);  // whose squares are no normal numbers
    if (moved ? heading < held - edge : heading > held + edge) return {kInfinity, false};
    if (!moved && grip.p_WG != before.p_WG) return {kInfinity, true};
  }
  if (!moved) return {0.0, true};
  const Real length = Real(friction.dynamic_share) * depth;
  const Real3 right = real(p_WP) + Real(length / heading) * along;
  return {ulpsOf(grip.p_WG, right, Real(largestOf(p_WP)) + length), false};
}

constexpr const char* kRing =
    "ulp of the largest coordinate, and of R times (|CT| / off the axis + 1 / stylus off the axis + 2 |alpha| / blend)";

constexpr std::array<Row, 4> kRows{{
    {"influence_circle", Kind::Target, "Circle with the stylus's orientation: target", kRing, 64, 4, judgeCircle},
    {"influence_cylinder", Kind::Target, "Cylinder with the stylus's orientation: target", kRing, 64, 4, judgeCylinder},
    {"influence_sphere", Kind::Target, "Sphere with the stylus's orientation: target",
     "ulp of the largest coordinate, and of R (past a quarter turn R / sine of the angle between)", 64, 4, judgeSphere},
    {"friction_grip", Kind::Target, "Friction: whether the target slides, and where to",
     "ulp of the target's largest coordinate and the remaining distance", 16, 1, judgeGrip},
}};

}  // namespace influence_rows

constinit const std::span<const Row> kInfluenceRows = influence_rows::kRows;

}  // namespace underact::error_bounds
