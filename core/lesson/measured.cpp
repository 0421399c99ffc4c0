#include "core/lesson/measured.h"

#include <algorithm>
#include <cmath>

#include "core/arm/branches.h"
#include "core/arm/conventions.h"
#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "core/arm/statics.h"
#include "core/base/units.h"

namespace underact::lesson {
namespace {

constexpr double kCubicCentimetres = 1e6;  // of a cubic metre
constexpr double kMillijoules = 1e3;       // of a joule
constexpr double kLeastError_m = 0.2e-3;   // below it friction and encoder steps decide what a quotient says
constexpr double kNoForce_N = 1e-3;

Values unknown() {
  Values values;
  values.fill(kNotANumber);
  return values;
}

Values one(double value) {
  Values values = unknown();
  values[0] = value;
  return values;
}

Values three(const Vec3& vector) {
  Values values = unknown();
  std::copy_n(vector.data(), 3, values.begin());
  return values;
}

Values inDegrees(const arm::JointAngles& angles_rad) {
  Values values = unknown();
  std::transform(angles_rad.begin(), angles_rad.end(), values.begin(), [](double a) { return a / kRadPerDegree; });
  return values;
}

arm::Solutions solutionsOf(const Seen& seen) {
  const arm::Geometry& geometry = seen.arm.geometry;
  return arm::solveAll(geometry, seen.arm.limits, arm::tipPose(geometry, seen.tick.q_rad));
}

arm::Dexterity dexterityOf(const Seen& seen) {
  return arm::dexterity(seen.arm.geometry, seen.tick.q_rad);
}

arm::SingularityDistances distancesOf(const Seen& seen) {
  return arm::singularityDistances(seen.arm.geometry, seen.tick.q_rad);
}

/// From the target to the tip; not a number where no target acts.
Vec3 offset_m(const Seen& seen) {
  return seen.tick.p_WT - seen.tick.p_WP;
}

/// How far apart two sets of joint angles are: the largest of their differences, each the short way round.
double turnBetween(const arm::JointAngles& a_rad, const arm::JointAngles& b_rad) {
  double largest_rad = 0.0;
  for (std::size_t i = 0; i < a_rad.size(); ++i) {
    largest_rad = std::max(largest_rad, std::abs(std::remainder(a_rad[i] - b_rad[i], 2.0 * kPi)));
  }
  return largest_rad;
}

const scene::Control& control(const Seen& seen) {
  return scene::controlOf(seen.scene, 0);
}

const scene::VirtualManipulator* robotOf(const scene::Description& scene) {
  for (const scene::Constraint& constraint : scene.constraints) {
    if (const auto* robot = std::get_if<scene::VirtualManipulator>(&constraint.shape)) return robot;
  }
  return nullptr;
}

}  // namespace

Values tip_mm(const Seen& seen) {
  return three(kMillimetrePerMetre * seen.tick.p_WT);
}

Values tipInBase_mm(const Seen& seen) {
  const Vec3 p_BT_W = seen.tick.p_WT - seen.arm.geometry.p_WB;
  return three(kMillimetrePerMetre * (arm::workspaceFromBase().transpose() * p_BT_W));
}

Values velocity_mm_per_s(const Seen& seen) {
  return three(kMillimetrePerMetre * seen.tick.v_WT);
}

Values speed_mm_per_s(const Seen& seen) {
  return one(kMillimetrePerMetre * seen.tick.v_WT.norm());
}

Values stylus(const Seen& seen) {
  return three(arm::tipPose(seen.arm.geometry, seen.tick.q_rad).linear().col(2));
}

Values joints_deg(const Seen& seen) {
  return inDegrees(seen.tick.q_rad);
}

Values device_deg(const Seen& seen) {
  return inDegrees(arm::deviceFromDh(seen.tick.q_rad));
}

// In the order in which the solutions are numbered everywhere: shoulder, elbow, wrist, + before -.
Values branch(const Seen& seen) {
  const arm::Solutions all = solutionsOf(seen);
  const arm::Solution* const nearest =
      std::min_element(all.begin(), all.end(), [&seen](const arm::Solution& a, const arm::Solution& b) {
        return turnBetween(a.q_rad, seen.tick.q_rad) < turnBetween(b.q_rad, seen.tick.q_rad);
      });
  if (nearest == all.end()) return unknown();
  const arm::Branch& is = nearest->branch;
  return one(1.0 + (is.shoulder < 0 ? 4.0 : 0.0) + (is.elbow < 0 ? 2.0 : 0.0) + (is.wrist < 0 ? 1.0 : 0.0));
}

Values solutions(const Seen& seen) {
  return one(static_cast<double>(solutionsOf(seen).count));
}

Values solutionsWithin(const Seen& seen) {
  const arm::Solutions all = solutionsOf(seen);
  return one(static_cast<double>(
      std::count_if(all.begin(), all.end(), [](const arm::Solution& one) { return one.within_limits; })));
}

Values det_cm3(const Seen& seen) {
  return one(kCubicCentimetres * dexterityOf(seen).det_m3);
}

Values manipulability_cm3(const Seen& seen) {
  return one(kCubicCentimetres * dexterityOf(seen).manipulability_m3);
}

Values gains_mm(const Seen& seen) {
  return three(kMillimetrePerMetre * dexterityOf(seen).gain_m);
}

Values shoulder_mm(const Seen& seen) {
  return one(kMillimetrePerMetre * distancesOf(seen).shoulder_m);
}

Values elbow_deg(const Seen& seen) {
  return one(distancesOf(seen).elbow_rad / kRadPerDegree);
}

Values wrist_deg(const Seen& seen) {
  return one(distancesOf(seen).wrist_rad / kRadPerDegree);
}

Values limit_deg(const Seen& seen) {
  double least_rad = kInfinity;
  for (std::size_t joint = 0; joint < 3; ++joint) {
    const double q_rad = seen.tick.q_rad[joint];
    least_rad = std::min({least_rad, q_rad - seen.arm.limits.min_rad[joint], seen.arm.limits.max_rad[joint] - q_rad});
  }
  return one(std::max(least_rad, 0.0) / kRadPerDegree);
}

Values force_N(const Seen& seen) {
  return one(seen.tick.f_sent_T_W.norm());
}

Values forceVector_N(const Seen& seen) {
  return three(seen.tick.f_sent_T_W);
}

Values asked_N(const Seen& seen) {
  return one(seen.tick.f_asked_T_W.norm());
}

Values torque_N_mm(const Seen& seen) {
  const Vec3 torque_N_m = arm::torqueOf(seen.arm.geometry, seen.tick.q_rad, seen.tick.f_sent_T_W);
  return three(kMillimetrePerMetre * torque_N_m);
}

Values error_mm(const Seen& seen) {
  return one(kMillimetrePerMetre * seen.tick.error_m);
}

Values offset_mm(const Seen& seen) {
  return three(kMillimetrePerMetre * offset_m(seen));
}

Values stiffness_N_per_mm(const Seen& seen) {
  if (seen.tick.error_m < kLeastError_m) return unknown();
  return one(seen.tick.f_asked_T_W.norm() / (kMillimetrePerMetre * seen.tick.error_m));
}

Values lean_deg(const Seen& seen) {
  const Vec3 way_m = -offset_m(seen);
  const Vec3& f_N = seen.tick.f_asked_T_W;
  if (!(way_m.norm() >= kLeastError_m && f_N.norm() >= kNoForce_N)) return unknown();
  return one(std::atan2(way_m.cross(f_N).norm(), way_m.dot(f_N)) / kRadPerDegree);
}

Values cut_N(const Seen& seen) {
  return one(seen.tick.cut_N);
}

Values energy_mJ(const Seen& seen) {
  return one(kMillijoules * seen.tick.energy_J);
}

Values passive_N(const Seen& seen) {
  return one(seen.tick.passive_N);
}

Values kp_N_per_mm(const Seen& seen) {
  return three(control(seen).gains.kp_N_per_mm);
}

Values kd_N_s_per_mm(const Seen& seen) {
  if (control(seen).law == scene::LawType::P) return three(Vec3::Zero());
  return three(control(seen).gains.kd_N_s_per_mm);
}

Values influence_t(const Seen& seen) {
  for (const scene::Constraint& constraint : seen.scene.constraints) {
    if (constraint.influence) return one(constraint.influence->t);
  }
  return one(1.0);  // switched off: position only
}

Values influence_deg(const Seen& seen) {
  const target::Angles& angles = seen.tick.angles;
  return three(Vec3(angles.alpha_rad, angles.beta_rad, angles.theta_rad) / kRadPerDegree);
}

Values robotJoints(const Seen& seen) {
  const scene::VirtualManipulator* const robot = robotOf(seen.scene);
  Values values = unknown();
  if (robot == nullptr || robot->joints.size() != seen.robot.joints) return values;  // just edited
  for (std::size_t joint = 0; joint < robot->joints.size(); ++joint) {
    const bool turns = robot->joints[joint].type == chain::JointType::Revolute;
    values[joint] = seen.robot.theta[joint] * (turns ? 1.0 / kRadPerDegree : kMillimetrePerMetre);
  }
  return values;
}

Values robotEnergy_mJ(const Seen& seen) {
  return seen.robot.joints == 0 ? unknown() : one(kMillijoules * seen.robot.energy_J);
}

Values moment_N_mm(const Seen& seen) {
  return seen.robot.joints == 0 ? unknown() : one(kMillimetrePerMetre * seen.robot.moment_W.norm());
}

Values button(const Seen& seen) {
  return one((seen.tick.buttons & 1U) != 0 ? 1.0 : 0.0);
}

}  // namespace underact::lesson
