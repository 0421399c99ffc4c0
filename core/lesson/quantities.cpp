#include <algorithm>
#include <cmath>

#include "core/arm/branches.h"
#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "core/arm/mechanism.h"
#include "core/arm/model.h"
#include "core/arm/sample.h"
#include "core/arm/statics.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/chain/inverse.h"
#include "core/lesson/quantity.h"
#include "core/scene/scene_arm.h"

namespace underact::lesson {
namespace {

constexpr double kCubicCentimetres = 1e6;  // of a cubic metre
constexpr double kMillijoules = 1e3;       // of a joule
constexpr double kMinError_m = 0.2e-3;     // below it friction and encoder steps dominate a quotient
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

/// The angles of turret, thigh and shin and of the gimbal.
Values deviceAngles_deg(const Observation& seen) {
  const arm::JointAngles angles_rad = arm::deviceFromDh(seen.tick.q_rad);
  Values values = unknown();
  std::transform(angles_rad.begin(), angles_rad.begin() + 6, values.begin(),
                 [](double a) { return a / kRadPerDegree; });
  return values;
}

/// Of each joint, in degrees, or mm where it slides.
Values joints(const Observation& seen) {
  Values values = unknown();
  for (std::size_t joint = 0; joint < arm::jointsOf(seen.arm.geometry); ++joint) {
    const double q = seen.tick.q_rad[joint];
    values[joint] = arm::slides(seen.arm.geometry, joint) ? kMillimetrePerMetre * q : q / kRadPerDegree;
  }
  return values;
}

arm::Solutions solutionsOf(const Observation& seen) {
  const arm::Geometry& geometry = seen.arm.geometry;
  return arm::solveAll(geometry, seen.arm.limits, arm::tipPose(geometry, seen.tick.q_rad));
}

/// How many solutions the pose has, and how many are within the limits; not numbers: the arm has no closed form.
struct Count {
  double all = kNotANumber, within = kNotANumber;
};
Count countOf(const Observation& seen) {
  if (arm::solvesInTick(seen.arm.geometry)) {
    const arm::Solutions all = solutionsOf(seen);
    const auto within =
        std::count_if(all.begin(), all.end(), [](const arm::Solution& one) { return one.within_limits; });
    return {static_cast<double>(all.count), static_cast<double>(within)};
  }
  const chain::Inverse inverse = chain::inverseOf(seen.arm.geometry.mechanism->chain);
  if (!inverse.isClosed()) return {};
  const chain::InverseSolutions found = chain::solveAll(inverse, arm::tipPose(seen.arm.geometry, seen.tick.q_rad));
  Count count{0.0, 0.0};
  for (std::size_t index = 0; index < found.count; ++index) {
    chain::JointValues values = found.all[index].q;
    const std::span<double> q = std::span(values).first(inverse.chain.joints.size());
    count.all += 1.0;
    arm::turnIntoLimits(scene::modelOf(seen.scene), q);
    if (arm::isWithinLimits(scene::modelOf(seen.scene), q)) count.within += 1.0;
  }
  return count;
}

arm::Dexterity dexterityOf(const Observation& seen) {
  return arm::dexterityOf(seen.arm.geometry, seen.tick.q_rad);
}

arm::SingularityDistances distancesOf(const Observation& seen) {
  return arm::singularityDistances(seen.arm.geometry, seen.tick.q_rad);
}

/// From the target to the tip; NaN if no target is active.
Vec3 offset_m(const Observation& seen) {
  return seen.tick.p_WT - seen.tick.p_WP;
}

/// The largest difference of two sets of joint angles, each the short way round.
double turnBetween(const arm::JointAngles& a_rad, const arm::JointAngles& b_rad) {
  double largest_rad = 0.0;
  for (std::size_t i = 0; i < a_rad.size(); ++i) {
    largest_rad = std::max(largest_rad, std::abs(std::remainder(a_rad[i] - b_rad[i], 2.0 * kPi)));
  }
  return largest_rad;
}

const scene::Control& control(const Observation& seen) {
  return scene::controlOf(seen.scene, 0);
}

const scene::VirtualManipulator* robotOf(const scene::Description& scene) {
  for (const scene::Constraint& constraint : scene.constraints) {
    if (const auto* robot = std::get_if<scene::VirtualManipulator>(&constraint.shape)) return robot;
  }
  return nullptr;
}

Values tipInBase_mm(const Observation& seen) {
  return three(kMillimetrePerMetre * (seen.arm.geometry.mechanism->X_WB.inverse(Eigen::Isometry) * seen.tick.p_WT));
}

// In the order in which the solutions are numbered everywhere: shoulder, elbow, wrist, + before -.
Values branch(const Observation& seen) {
  const arm::Solutions all = solutionsOf(seen);
  const arm::Solution* const nearest =
      std::min_element(all.begin(), all.end(), [&seen](const arm::Solution& a, const arm::Solution& b) {
        return turnBetween(a.q_rad, seen.tick.q_rad) < turnBetween(b.q_rad, seen.tick.q_rad);
      });
  if (nearest == all.end()) return unknown();
  const arm::Branch& is = nearest->branch;
  return one(1.0 + (is.shoulder < 0 ? 4.0 : 0.0) + (is.elbow < 0 ? 2.0 : 0.0) + (is.wrist < 0 ? 1.0 : 0.0));
}

Values solutions(const Observation& seen) {
  return one(countOf(seen).all);
}

Values solutionsWithin(const Observation& seen) {
  return one(countOf(seen).within);
}

Values limit_deg(const Observation& seen) {
  if (!arm::solvesInTick(seen.arm.geometry)) return unknown();
  double lowest_rad = kInfinity;
  for (std::size_t joint = 0; joint < 3; ++joint) {
    const double q_rad = seen.tick.q_rad[joint];
    lowest_rad = std::min({lowest_rad, q_rad - seen.arm.limits.min_rad[joint], seen.arm.limits.max_rad[joint] - q_rad});
  }
  return one(std::max(lowest_rad, 0.0) / kRadPerDegree);
}

Values stiffness_N_per_mm(const Observation& seen) {
  if (seen.tick.error_m < kMinError_m) return unknown();
  return one(seen.tick.f_asked_T_W.norm() / (kMillimetrePerMetre * seen.tick.error_m));
}

Values lean_deg(const Observation& seen) {
  const Vec3 travel_m = -offset_m(seen);
  const Vec3& f_N = seen.tick.f_asked_T_W;
  if (!(travel_m.norm() >= kMinError_m && f_N.norm() >= kNoForce_N)) return unknown();
  return one(std::atan2(travel_m.cross(f_N).norm(), travel_m.dot(f_N)) / kRadPerDegree);
}

Values kd_N_s_per_mm(const Observation& seen) {
  if (control(seen).law == scene::LawType::P) return three(Vec3::Zero());
  return three(control(seen).gains.kd_N_s_per_mm);
}

Values influence_t(const Observation& seen) {
  for (const scene::Constraint& constraint : seen.scene.constraints) {
    if (constraint.influence) return one(constraint.influence->t);
  }
  return one(1.0);  // switched off: position only
}

Values influence_deg(const Observation& seen) {
  const target::Angles& angles = seen.tick.angles;
  return three(Vec3(angles.alpha_rad, angles.beta_rad, angles.theta_rad) / kRadPerDegree);
}

Values robotJoints(const Observation& seen) {
  const scene::VirtualManipulator* const robot = robotOf(seen.scene);
  Values values = unknown();
  if (robot == nullptr || robot->joints.size() != seen.robot.joints) return values;  // just edited
  for (std::size_t joint = 0; joint < robot->joints.size(); ++joint) {
    const bool turns = robot->joints[joint].type == chain::JointType::Revolute;
    values[joint] = seen.robot.theta[joint] * (turns ? 1.0 / kRadPerDegree : kMillimetrePerMetre);
  }
  return values;
}

}  // namespace

std::span<const Quantity> quantities() {
  using enum DistanceMetric;
  using enum Needs;
  static constexpr Quantity kAll[] = {
      {"tip_mm", TRANSLATE_NOOP("problem", "The tip"), "mm", 1, 3, Euclidean, Nothing,
       "Position of the tip in the workspace frame W.",
       [](const Observation& seen) { return three(kMillimetrePerMetre * seen.tick.p_WT); }},
      {"tip_in_base_mm", TRANSLATE_NOOP("problem", "The tip in B"), "mm", 1, 3, Euclidean, Nothing,
       "Position of the tip in B, frame 0 of the DH table.", tipInBase_mm},
      {"velocity_mm_per_s", TRANSLATE_NOOP("problem", "The velocity"), "mm/s", 1, 3, Euclidean, Nothing,
       "Velocity of the tip in W, filtered.",
       [](const Observation& seen) { return three(kMillimetrePerMetre * seen.tick.v_WT); }},
      {"speed_mm_per_s", TRANSLATE_NOOP("problem", "The speed"), "mm/s", 1, 1, Euclidean, Nothing,
       "Magnitude of the velocity.",
       [](const Observation& seen) { return one(kMillimetrePerMetre * seen.tick.v_WT.norm()); }},
      {"stylus", TRANSLATE_NOOP("problem", "The direction of the stylus"), "", 2, 3, Angle, Nothing,
       "Direction of the stylus: z of frame 6 in W. The distance between two directions is an angle.",
       [](const Observation& seen) { return three(arm::tipPose(seen.arm.geometry, seen.tick.q_rad).linear().col(2)); }},
      {"q_deg", TRANSLATE_NOOP("problem", "Joint angle"), "°", 1, 8, Largest, Nothing,
       "Joint angles of the DH table; prismatic joints in mm.", joints},
      {"device_deg", TRANSLATE_NOOP("problem", "Device angle"), "°", 1, 6, Largest, Nothing,
       "The device's own angles: turret, thigh, shin (from the base), gimbal 1 to 3.", deviceAngles_deg},
      {"branch", TRANSLATE_NOOP("problem", "The solution"), "", 0, 1, Euclidean, Nothing,
       "Number of the arm's current inverse solution, as in the panel Kinematics.", branch},
      {"solutions", TRANSLATE_NOOP("problem", "The number of inverse solutions"), "", 0, 1, Euclidean, Nothing,
       "Number of inverse solutions of the pose.", solutions},
      {"solutions_within", TRANSLATE_NOOP("problem", "The number of solutions within the limits"), "", 0, 1, Euclidean,
       Nothing, "Number of them with every joint within its limits.", solutionsWithin},
      {"det_Jp_cm3", TRANSLATE_NOOP("problem", "The determinant of J_p"), "cm³", 1, 1, Euclidean, Nothing,
       "Determinant of the 3x3 Jacobian J_p.",
       [](const Observation& seen) { return one(kCubicCentimetres * dexterityOf(seen).det_m3); }},
      {"manipulability_cm3", TRANSLATE_NOOP("problem", "The manipulability"), "cm³", 1, 1, Euclidean, Nothing,
       "Its absolute value (Yoshikawa).",
       [](const Observation& seen) { return one(kCubicCentimetres * dexterityOf(seen).manipulability_m3); }},
      {"gains_mm", TRANSLATE_NOOP("problem", "The singular value of J_p"), "mm", 1, 3, Euclidean, Nothing,
       "Singular values of J_p: motion of the tip per radian, largest first.",
       [](const Observation& seen) { return three(kMillimetrePerMetre * dexterityOf(seen).gain_m); }},
      {"shoulder_mm", TRANSLATE_NOOP("problem", "The distance from axis 1"), "mm", 1, 1, Euclidean, Nothing,
       "Distance of the wrist centre from axis 1; 0 is the shoulder singularity.",
       [](const Observation& seen) { return one(kMillimetrePerMetre * distancesOf(seen).shoulder_m); }},
      {"elbow_deg", TRANSLATE_NOOP("problem", "The distance from a stretched or folded elbow"), "°", 1, 1, Largest,
       Nothing, "Distance of q3 from 90 or -90 degrees; 0 is the elbow singularity.",
       [](const Observation& seen) { return one(distancesOf(seen).elbow_rad / kRadPerDegree); }},
      {"wrist_deg", TRANSLATE_NOOP("problem", "The distance from aligned axes 4 and 6"), "°", 1, 1, Largest, Nothing,
       "Distance of q5 from 0 or 180 degrees; 0 is the wrist singularity.",
       [](const Observation& seen) { return one(distancesOf(seen).wrist_rad / kRadPerDegree); }},
      {"limit_deg", TRANSLATE_NOOP("problem", "The distance to the nearest joint limit"), "°", 1, 1, Largest, Nothing,
       "Distance to the nearest joint limit of joints 1 to 3.", limit_deg},
      {"force_N", TRANSLATE_NOOP("problem", "The force"), "N", 2, 1, Euclidean, Nothing,
       "Magnitude of the force that is sent.",
       [](const Observation& seen) { return one(seen.tick.f_sent_T_W.norm()); }},
      {"force_vector_N", TRANSLATE_NOOP("problem", "The force"), "N", 2, 3, Euclidean, Nothing,
       "The force that is sent, in W.", [](const Observation& seen) { return three(seen.tick.f_sent_T_W); }},
      {"asked_N", TRANSLATE_NOOP("problem", "The commanded force"), "N", 2, 1, Euclidean, Nothing,
       "Magnitude of the commanded force, before the limits.",
       [](const Observation& seen) { return one(seen.tick.f_asked_T_W.norm()); }},
      {"torque_N_mm", TRANSLATE_NOOP("problem", "Joint torque"), "N mm", 1, 3, Euclidean, Nothing,
       "Torques of joints 1 to 3 for the force that is sent: J_p transposed times f.",
       [](const Observation& seen) {
         return three(kMillimetrePerMetre * arm::torqueOf(seen.arm.geometry, seen.tick.q_rad, seen.tick.f_sent_T_W));
       }},
      {"error_mm", TRANSLATE_NOOP("problem", "The error"), "mm", 1, 1, Euclidean, Nothing,
       "Distance from the tip to the target, over all active constraints.",
       [](const Observation& seen) { return one(kMillimetrePerMetre * seen.tick.error_m); }},
      {"offset_mm", TRANSLATE_NOOP("problem", "The displacement from target to tip"), "mm", 1, 3, Euclidean, Nothing,
       "From the target to the tip, for the first active constraint, in W.",
       [](const Observation& seen) { return three(kMillimetrePerMetre * offset_m(seen)); }},
      {"stiffness_N_per_mm", TRANSLATE_NOOP("problem", "The stiffness felt"), "N/mm", 2, 1, Euclidean, Nothing,
       "Commanded force divided by the error, for errors of 0.2 mm or more.", stiffness_N_per_mm},
      {"lean_deg", TRANSLATE_NOOP("problem", "The angle between the force and the direction to the target"), "°", 1, 1,
       Largest, Nothing, "Angle between the force and the direction to the target; 0: straight to it.", lean_deg},
      {"cut_N", TRANSLATE_NOOP("problem", "The force that the limits take off"), "N", 2, 1, Euclidean, Nothing,
       "The part of the commanded force that the limits take off.",
       [](const Observation& seen) { return one(seen.tick.cut_N); }},
      {"energy_mJ", TRANSLATE_NOOP("problem", "The energy"), "mJ", 2, 1, Euclidean, Energy,
       "Energy that the stylus has put in and not got back; below 0 the scene is active.",
       [](const Observation& seen) { return one(kMillijoules * seen.tick.energy_J); }},
      {"passive_N", TRANSLATE_NOOP("problem", "The damping force of the passivity controller"), "N", 2, 1, Euclidean,
       Energy, "Damping force of the passivity controllers.",
       [](const Observation& seen) { return one(seen.tick.passive_N); }},
      {"kp_N_per_mm", TRANSLATE_NOOP("problem", "The stiffness kp"), "N/mm", 2, 3, Euclidean, Nothing,
       "Stiffness of the first constraint, along x, y, z.",
       [](const Observation& seen) { return three(control(seen).gains.kp_N_per_mm); }},
      {"kd_N_s_per_mm", TRANSLATE_NOOP("problem", "The damping kd"), "N s/mm", 4, 3, Euclidean, Nothing,
       "Damping of the first constraint; 0 if the control law has none.", kd_N_s_per_mm},
      {"influence_t", TRANSLATE_NOOP("problem", "The influence factor t"), "", 2, 1, Euclidean, Influence,
       "Influence factor; 0: orientation only, 1: position only.", influence_t},
      {"influence_deg", TRANSLATE_NOOP("problem", "The angle about the shape's axis"), "°", 1, 3, Largest, Influence,
       "Angles of the stylus (alpha), the tip (beta) and the target (theta).", influence_deg},
      {"robot", TRANSLATE_NOOP("problem", "The virtual robot's joint"), "°", 1, 8, Largest, Robot,
       "Joints of the first virtual robot; prismatic joints in mm.", robotJoints},
      {"robot_energy_mJ", TRANSLATE_NOOP("problem", "The robot's energy"), "mJ", 2, 1, Euclidean, Robot,
       "Energy of the robot's springs.",
       [](const Observation& seen) {
         return seen.robot.joints == 0 ? unknown() : one(kMillijoules * seen.robot.energy_J);
       }},
      {"moment_N_mm", TRANSLATE_NOOP("problem", "The moment that is not sent"), "N mm", 1, 1, Euclidean, Robot,
       "Magnitude of the moment, which is not sent.",
       [](const Observation& seen) {
         return seen.robot.joints == 0 ? unknown() : one(kMillimetrePerMetre * seen.robot.moment_W.norm());
       }},
      {"button", TRANSLATE_NOOP("problem", "The stylus button"), "", 0, 1, Euclidean, Nothing,
       "1 while the stylus button is held.",
       [](const Observation& seen) { return one((seen.tick.buttons & 1U) != 0 ? 1.0 : 0.0); }},
  };
  return kAll;
}

}  // namespace underact::lesson
