#include "core/tick/cost.h"

#include <algorithm>
#include <cmath>

namespace underact::tick {
namespace {

// ns, measured by underact-bench (resources/guide/figures.md).
constexpr double kKinematics_ns = 88.0;
constexpr double kGateAndReport_ns = 140.0;
constexpr double kPoint_ns = 3.0;
constexpr double kSphere_ns = 3.0;
constexpr double kLine_ns = 4.0;
constexpr double kPlane_ns = 3.0;
constexpr double kCircle_ns = 18.0;
constexpr double kCylinder_ns = 15.0;
constexpr double kBox_ns = 7.0;
constexpr double kByIteration_ns = 165.0;  // of quadrics, and of a box with unequal gains
constexpr double kP_ns = 1.0;
constexpr double kPD_ns = 11.0;
constexpr double kPID_ns = 18.0;
constexpr double kKalman_ns = 14.0;        // beyond the low-pass, which is in that of the law
constexpr double kWindowOfTick_ns = 15.0;  // of an adaptive window, for each of its ticks
constexpr double kObserve_ns = 28.0;
constexpr double kPassive_ns = 60.0;     // observed and damped
constexpr double kInfluence_ns = 130.0;  // the wrist, and the target between orientation and position
constexpr double kWrist_ns = 60.0;
constexpr double kClosedForm_ns = 130.0;    // of a virtual manipulator
constexpr double kStepsOf_ns = 60.0;        // by iteration: the two evaluations and the step of a warm start ...
constexpr double kStepsOfJoint_ns = 160.0;  // ... for each joint
constexpr double kJoints_ns = 250.0;        // the joint angles of a target, and the force of their torques

constexpr double kFriction_ns = 12.0;
constexpr double kCurve_ns = 450.0, kCurveOfDoubling_ns = 40.0;  // a spline of 100 points, and each doubling
// Of a mesh (underact-mesh-tick-bench): a search at 1000 triangles, and the increase with each doubling, warm and in
// the tree alone; the local search and a wall's proxy; smoothing of the force.
constexpr double kSearch_ns = 100.0, kHybridOfDoubling_ns = 55.0, kGlobalOfDoubling_ns = 150.0, kWalk_ns = 100.0;
constexpr double kLean_ns = 900.0;

struct ShapeCost {
  double operator()(const shape::Point&) const { return kPoint_ns; }
  double operator()(const shape::Sphere&) const { return kSphere_ns; }
  double operator()(const shape::Line&) const { return kLine_ns; }
  double operator()(const shape::Plane&) const { return kPlane_ns; }
  double operator()(const shape::Circle&) const { return kCircle_ns; }
  double operator()(const shape::Cylinder&) const { return kCylinder_ns; }
  double operator()(const shape::Box&) const { return kBox_ns; }
  double operator()(const shape::Ellipsoid&) const { return kByIteration_ns; }
  double operator()(const shape::Ellipse&) const { return kByIteration_ns; }
  double operator()(const shape::EllipticCylinder&) const { return kByIteration_ns; }
  double operator()(const shape::Parallelepiped&) const { return kByIteration_ns; }
};

double costOf(const control::Velocity& velocity) {
  if (const auto* adaptive = std::get_if<control::AdaptiveWindow>(&velocity))
    return kWindowOfTick_ns * adaptive->window;
  return std::holds_alternative<control::Kalman>(velocity) ? kKalman_ns : 0.0;
}

struct LawCost {
  double operator()(const control::P&) const { return kP_ns; }
  double operator()(const control::PD& pd) const { return kPD_ns + costOf(pd.velocity); }
  double operator()(const control::PID& pid) const { return kPID_ns + costOf(pid.velocity); }
};

double costOf(control::Passivity passivity) {
  if (passivity == control::Passivity::Off) return 0.0;
  return passivity == control::Passivity::Control ? kPassive_ns : kObserve_ns;
}

struct GoalCost {
  target::Side side;
  double operator()(const target::NearestOnShape& held) const { return std::visit(ShapeCost{}, held.shape); }
  double operator()(const target::InfluencedShape& held) const {
    return std::visit(ShapeCost{}, held.shape) + kInfluence_ns;
  }
  double operator()(const target::MeshPlace& place) const {
    const double lean_ns = place.lean.isThere() ? kLean_ns : 0.0;
    if (side != target::Side::Both || place.search == mesh::Search::Local) return kWalk_ns + lean_ns;
    const auto faces = static_cast<double>(place.surface->triangles.faces.size());
    const double of_doubling_ns = place.search == mesh::Search::Global ? kGlobalOfDoubling_ns : kHybridOfDoubling_ns;
    return kSearch_ns + of_doubling_ns * std::max(0.0, std::log2(faces / 1000.0)) + lean_ns;
  }
  double operator()(const target::CurvePath& path) const {
    const double pieces = curve::pieceCount(*path.curve);
    return kCurve_ns + kCurveOfDoubling_ns * std::max(0.0, std::log2(pieces / 100.0));
  }
  double operator()(const manipulator::Manipulator& robot) const {
    const double turn_ns = robot.orientation == manipulator::Orientation::None ? 0.0 : kWrist_ns;
    if (robot.closed) return turn_ns + kClosedForm_ns;
    return turn_ns + kStepsOf_ns + kStepsOfJoint_ns * static_cast<double>(robot.chain.joints.size());
  }
};

}  // namespace

double predictedCost_ns(const TickProgram& program) {
  double cost_ns = kKinematics_ns + kGateAndReport_ns;
  for (const Entry& entry : program.entries) {
    cost_ns += std::visit(GoalCost{entry.constraint.side}, entry.constraint.goal);
    if (entry.constraint.friction.isThere()) cost_ns += kFriction_ns;
    cost_ns += std::visit(LawCost{}, entry.law);
    cost_ns += costOf(entry.passivity);
    if (entry.space == Space::Joint) cost_ns += kJoints_ns;
  }
  return cost_ns;
}

}  // namespace underact::tick
