#include "app/gui/view/arm_solids.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace underact::gui {
namespace {

using chain::JointType;

constexpr double kParallel = 1e-6;
// Shares of the reach.
constexpr double kSamePlaceShare = 0.02, kHousingShare = 0.026, kCarriedShare = 0.034, kShoulderShare = 0.45;
constexpr double kSlender = 0.8;         // a haptic device's links, relative to a robot's
constexpr double kOpenRangeShare = 0.5;  // of a slide without limits
// Of a housing's radius.
constexpr double kTipShare = 0.5, kHalfLength = 1.15, kAcross = 1.3, kRoundedEdge = 0.28, kLinkRadius = 0.72,
                 kLongTube = 3.0;

double reachOfModel(const arm::Model& model) {
  const double reach_m = chain::reachOf(model.chain);
  return std::isfinite(reach_m) && reach_m > 1e-6 ? reach_m : kOmniReach_m;
}

/// The points of two lines that are nearest to each other; of parallel ones `a` and its foot on the other.
std::array<Vec3, 2> nearestPoints(const Vec3& a, const Vec3& a_axis, const Vec3& b, const Vec3& b_axis) {
  const Vec3 common = a_axis.cross(b_axis), direction = b - a;
  if (common.norm() < kParallel) return {a, Vec3(b - direction.dot(b_axis) * b_axis)};
  const double along_a = direction.cross(b_axis).dot(common) / common.squaredNorm();
  const double along_b = direction.cross(a_axis).dot(common) / common.squaredNorm();
  return {Vec3(a + along_a * a_axis), Vec3(b + along_b * b_axis)};
}

/// A point on each axis. A slide has a direction only: its axis goes through the next point that the chain has.
std::vector<Vec3> pointsOnAxes(const chain::Chain& chain) {
  std::vector<Vec3> points(chain.joints.size());
  Vec3 next_W = chain.X_WT_home.translation();
  for (std::size_t back = chain.joints.size(); back-- > 0;) {
    points[back] = chain.joints[back].type == JointType::Revolute ? chain.joints[back].p_WJ : next_W;
    next_W = points[back];
  }
  return points;
}

/// What is drawn of joint `index`; `length` along its axis from in_W to out_W.
class JointMaker {
 public:
  JointMaker(ArmSolids& arm, const arm::Model& model) : arm_(arm), model_(model) {}

  void addRevolute(std::size_t index, bool is_crossed) {
    const DrawnAxis& axis = arm_.axes[index];
    const double length_m = (axis.out_W - axis.in_W).norm(), radius_m = axis.radius_m;
    const Vec3 along_W = length_m > 1e-9 ? Vec3((axis.out_W - axis.in_W) / length_m) : axis.axis_W;
    const Pose X_WS = frameAlong(axis.in_W, along_W);
    const double half_m = (is_crossed ? kAcross : kHalfLength) * radius_m;
    if (length_m <= kLongTube * radius_m) {
      add(index, Finish::Shell, TurnedForm{X_WS, roundedRod(-half_m, length_m + half_m, radius_m, edge(radius_m))});
      // The gap in which it turns, and the covers of its bearing.
      const double gap_m = 0.09 * radius_m, middle_m = 0.5 * length_m;
      if (!is_crossed) {
        add(index, Finish::Trim,
            TurnedForm{X_WS, roundedRod(middle_m - gap_m, middle_m + gap_m, 1.02 * radius_m, 0.5 * gap_m)});
      }
      for (const double end_m : {-half_m, length_m + half_m}) {
        const double out_m = end_m > 0.0 ? 0.07 * radius_m : -0.07 * radius_m;
        add(index, Finish::Trim,
            TurnedForm{X_WS, roundedRod(std::min(end_m, end_m + out_m), std::max(end_m, end_m + out_m), 0.62 * radius_m,
                                        0.05 * radius_m)});
      }
      return;
    }
    // A tube along the axis, up to the gap; behind it a housing that turns.
    const double collar_m = length_m - std::min(1.6 * radius_m, 0.3 * length_m);
    const double before_m = index > 0 ? arm_.axes[index - 1].radius_m : radius_m;
    add(index, Finish::Shell,
        TurnedForm{X_WS, taperedRod(0.0, collar_m, kLinkRadius * std::max(before_m, radius_m), 0.9 * radius_m)});
    const double gap_m = 0.14 * radius_m;
    add(index + 1, Finish::Trim,
        TurnedForm{X_WS, roundedRod(collar_m + 0.4 * radius_m, collar_m + 0.4 * radius_m + 2.0 * gap_m, 1.03 * radius_m,
                                    0.5 * gap_m)});
    add(index + 1, Finish::Shell,
        TurnedForm{X_WS, roundedRod(collar_m, length_m + 0.55 * radius_m, radius_m, edge(radius_m))});
  }

  /// A sleeve (first joint: a carriage) and the rail that slides in it.
  void addSlide(std::size_t index) {
    const DrawnAxis& axis = arm_.axes[index];
    const chain::Joint& joint = model_.chain.joints[index];
    const double radius_m = axis.radius_m, margin_m = 1.8 * radius_m;
    const double open_m = kOpenRangeShare * reachOfModel(model_);
    const double max_m = std::isfinite(joint.max) ? joint.max : open_m;
    const double min_m = std::isfinite(joint.min) ? joint.min : -open_m;
    const double end_m = (axis.out_W - axis.in_W).dot(axis.axis_W);
    double from_m = std::min(end_m, -max_m - margin_m), to_m = std::max(end_m, -min_m + margin_m);
    if (index == 0) {
      from_m = min_m - margin_m;
      to_m = max_m + margin_m;
    } else if (end_m >= -min_m) {
      to_m = end_m;
    } else if (end_m <= -max_m) {
      from_m = end_m;
    }
    const std::size_t rail = index == 0 ? 0 : index + 1, sleeve = index == 0 ? 1 : index;
    const Vec3 middle_W = axis.in_W + 0.5 * (from_m + to_m) * axis.axis_W;
    add(rail, Finish::Metal,
        BoxForm{frameAlong(middle_W, axis.axis_W),
                Vec3(0.5 * radius_m, 0.5 * radius_m, 0.5 * std::max(to_m - from_m, radius_m))});
    add(sleeve, Finish::Shell,
        BoxForm{frameAlong(axis.in_W, axis.axis_W), Vec3(0.95 * radius_m, 0.95 * radius_m, 1.5 * radius_m)});
    for (const double side : {-1.0, 1.0}) {
      add(sleeve, Finish::Trim,
          BoxForm{frameAlong(axis.in_W + 1.5 * side * radius_m * axis.axis_W, axis.axis_W),
                  Vec3(1.02 * radius_m, 1.02 * radius_m, 0.12 * radius_m)});
    }
  }

  /// Between two places of a link.
  void addLink(std::size_t link, const Vec3& from_W, const Vec3& to_W, double from_radius_m, double to_radius_m) {
    const double length_m = (to_W - from_W).norm();
    if (length_m < 0.3 * std::min(from_radius_m, to_radius_m)) return;
    add(link, Finish::Metal,
        TurnedForm{frameAlong(from_W, (to_W - from_W) / length_m),
                   taperedRod(0.0, length_m, kLinkRadius * from_radius_m, kLinkRadius * to_radius_m)});
  }

  void add(std::size_t link, Finish finish, Form form) { arm_.solids.push_back({link, finish, std::move(form)}); }

 private:
  static double edge(double radius_m) { return kRoundedEdge * radius_m; }

  ArmSolids& arm_;
  const arm::Model& model_;
};

/// The first `count` joints and the links between them. The first one of a haptic device is in its turret.
void addJoints(ArmSolids& arm, const arm::Model& model, std::size_t count) {
  const double near_m = kSamePlaceShare * reachOfModel(model);
  const bool is_device = arm::omniGeometry(model).has_value();
  JointMaker maker(arm, model);
  for (std::size_t index = 0; index < count; ++index) {
    const DrawnAxis& axis = arm.axes[index];
    if (axis.type == JointType::Prismatic) {
      maker.addSlide(index);
    } else if (!(is_device && index == 0)) {
      const bool is_crossed = index > 0 && (axis.in_W - arm.axes[index - 1].out_W).norm() < near_m;
      maker.addRevolute(index, is_crossed);
    }
    if (index + 1 < count)
      maker.addLink(index + 1, axis.out_W, arm.axes[index + 1].in_W, axis.radius_m, arm.axes[index + 1].radius_m);
  }
}

/// Whether the last three joints are revolute and meet in the tip.
bool hasGimbal(const ArmSolids& arm, double near_m) {
  const std::size_t count = arm.axes.size();
  if (count < 4) return false;
  for (std::size_t index = count - 3; index < count; ++index) {
    const DrawnAxis& axis = arm.axes[index];
    const Vec3 from_W = arm.p_WTip - axis.out_W;
    if (axis.type != JointType::Revolute || from_W.cross(axis.axis_W).norm() > near_m) return false;
  }
  return arm.axes[count - 3].axis_W.cross(arm.axes[count - 2].axis_W).norm() > 0.5;
}

}  // namespace

std::vector<DrawnAxis> drawnAxes(const arm::Model& model) {
  const std::vector<chain::Joint>& joints = model.chain.joints;
  const std::vector<Vec3> points = pointsOnAxes(model.chain);
  const Vec3 tip_W = model.chain.X_WT_home.translation();
  std::vector<DrawnAxis> axes(joints.size());
  for (std::size_t index = 0; index < joints.size(); ++index) {
    DrawnAxis& axis = axes[index];
    axis.type = joints[index].type;
    axis.axis_W = joints[index].axis_W;
    if (index == 0) axis.in_W = points[0];
    axis.out_W = axis.in_W;
    if (index + 1 < joints.size()) {
      const bool open = axis.axis_W.cross(joints[index + 1].axis_W).norm() < kParallel;
      const auto [out_W, next_W] =
          nearestPoints(open ? axis.in_W : points[index], axis.axis_W, points[index + 1], joints[index + 1].axis_W);
      axis.out_W = out_W;
      axes[index + 1].in_W = next_W;
      if (index == 0) axis.in_W = out_W;
    } else {
      axis.out_W = axis.in_W + (tip_W - axis.in_W).dot(axis.axis_W) * axis.axis_W;
      if (joints.size() == 1) axis.in_W = axis.out_W;
      // A last housing that reached to the tip would hide it.
      if (axis.type == JointType::Revolute && (axis.out_W - axis.in_W).norm() > 0.0) {
        const bool is_tip = (axis.out_W - tip_W).norm() < kSamePlaceShare * reachOfModel(model);
        if (is_tip) axis.out_W = axis.in_W;
      }
    }
  }
  // What is left to carry behind each joint, as a share of the whole.
  std::vector<double> left_m(joints.size() + 1, 0.0);
  for (std::size_t back = joints.size(); back-- > 0;) {
    const Vec3& next_W = back + 1 < joints.size() ? axes[back + 1].in_W : tip_W;
    left_m[back] = left_m[back + 1] + (axes[back].out_W - axes[back].in_W).norm() + (next_W - axes[back].out_W).norm();
  }
  const double reach_m = reachOfModel(model), slender = arm::omniGeometry(model) ? kSlender : 1.0;
  for (std::size_t index = 0; index < joints.size(); ++index) {
    const bool is_last_along = joints.size() > 3 && index + 3 >= joints.size();  // a wrist is slender
    const double share = left_m[0] > 0.0 ? left_m[is_last_along ? index + 1 : index] / left_m[0] : 1.0;
    axes[index].radius_m = slender * reach_m * (kHousingShare + kCarriedShare * std::min(1.0, share));
  }
  return axes;
}

ArmStand standOf(const arm::Model& model) {
  ArmStand stand;
  const double reach_m = reachOfModel(model);
  stand.size = reach_m / kOmniReach_m;
  const std::vector<DrawnAxis> axes = drawnAxes(model);
  const Vec3 shoulder_W = axes.empty() ? Vec3::Zero() : axes.front().out_W;
  if (arm::omniGeometry(model)) {
    stand.p_WG = shoulder_W - kShoulderShare * reach_m * stand.up_W();
    stand.p_DTop.z() = 0.4 * reach_m;  // it works before its foot
    return stand;
  }
  stand.R_WD << Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY();
  const double under_m = axes.empty() ? 0.0 : 2.6 * axes.front().radius_m;
  stand.p_WG = shoulder_W;
  stand.p_WG.z() = std::min(model.X_WB.translation().z(), shoulder_W.z() - under_m);
  return stand;
}

namespace {

/// Where an arm stands, turns and ends, without a solid.
ArmSolids begun(const arm::Model& model) {
  ArmSolids arm;
  arm.stand = standOf(model);
  arm.axes = drawnAxes(model);
  arm.p_WTip = arm.p_WEnd = model.chain.X_WT_home.translation();
  return arm;
}

}  // namespace

ArmSolids chainSolids(const arm::Model& model) {
  ArmSolids arm = begun(model);
  if (arm.axes.empty()) return arm;
  addJoints(arm, model, arm.axes.size());
  const DrawnAxis& last = arm.axes.back();
  JointMaker(arm, model).addLink(arm.axes.size(), last.out_W, arm.p_WTip, last.radius_m, kTipShare * last.radius_m);
  return arm;
}

namespace {

/// A solid of the arm's file.
Form formOf(const arm::LinkSolid& solid) {
  constexpr double kBevel = 0.05;  // of a radius
  if (const auto* const box = std::get_if<arm::BoxSolid>(&solid.form)) return BoxForm{solid.X_WS, 0.5 * box->size_m};
  if (const auto* const ball = std::get_if<arm::SphereSolid>(&solid.form))
    return TurnedForm{solid.X_WS, taperedRod(0.0, 0.0, ball->radius_m, ball->radius_m)};
  if (const auto* const rod = std::get_if<arm::CylinderSolid>(&solid.form))
    return TurnedForm{solid.X_WS,
                      roundedRod(-0.5 * rod->length_m, 0.5 * rod->length_m, rod->radius_m, kBevel * rod->radius_m)};
  const auto& capsule = std::get<arm::CapsuleSolid>(solid.form);
  return TurnedForm{solid.X_WS,
                    taperedRod(-0.5 * capsule.length_m, 0.5 * capsule.length_m, capsule.radius_m, capsule.radius_m)};
}

/// Those of the arm's file that can be drawn.
std::vector<ArmSolid> ownSolids(const arm::Model& model, const ArmMeshes& meshes) {
  std::vector<ArmSolid> solids;
  for (std::size_t index = 0; index < model.solids.size(); ++index) {
    const arm::LinkSolid& solid = model.solids[index];
    const std::size_t link = std::min(solid.link, model.chain.joints.size());
    const auto* const mesh = std::get_if<arm::MeshSolid>(&solid.form);
    if (mesh == nullptr) {
      solids.push_back({link, Finish::Shell, formOf(solid)});
    } else if (index < meshes.of_solids.size() && meshes.of_solids[index] != nullptr) {
      solids.push_back({link, Finish::Shell, MeshForm{solid.X_WS, mesh->m_per_unit, meshes.of_solids[index]}});
    }
  }
  return solids;
}

}  // namespace

ArmSolids solidsOf(const arm::Model& model, const ArmMeshes& meshes) {
  ArmSolids arm = begun(model);
  if (arm.axes.empty()) return arm;
  arm.solids = ownSolids(model, meshes);
  if (!arm.solids.empty()) {
    addStylus(arm, model);
    return arm;
  }
  const bool gimbal = hasGimbal(arm, kSamePlaceShare * reachOfModel(model));
  addBase(arm, arm::omniGeometry(model).has_value());
  addJoints(arm, model, gimbal ? arm.axes.size() - 3 : arm.axes.size());
  if (gimbal)
    addGimbal(arm, model);
  else
    addStylus(arm, model);
  return arm;
}

}  // namespace underact::gui
