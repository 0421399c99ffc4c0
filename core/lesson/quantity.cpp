#include "core/lesson/quantity.h"

#include <algorithm>

#include "core/base/translate.h"
#include "core/lesson/measured.h"

namespace underact::lesson {

std::span<const Quantity> quantities() {
  using enum Apart;
  using enum Needs;
  static constexpr Quantity kAll[] = {
      {"tip_mm", TRANSLATE_NOOP("problem", "The tip"), "mm", 1, 3, Way, Nothing,
       "The place of the tip in the workspace W.", tip_mm},
      {"tip_in_base_mm", TRANSLATE_NOOP("problem", "The tip in B"), "mm", 1, 3, Way, Nothing,
       "The same in B, frame 0 of the DH table.", tipInBase_mm},
      {"velocity_mm_per_s", TRANSLATE_NOOP("problem", "The velocity"), "mm/s", 1, 3, Way, Nothing,
       "The tip's velocity in W, filtered.", velocity_mm_per_s},
      {"speed_mm_per_s", TRANSLATE_NOOP("problem", "The speed"), "mm/s", 1, 1, Way, Nothing,
       "The size of the velocity.", speed_mm_per_s},
      {"stylus", TRANSLATE_NOOP("problem", "The stylus' direction"), "", 2, 3, Turn, Nothing,
       "Where the stylus points: z of frame 6 in W; how far it is from another direction is an angle.", stylus},
      {"q_deg", TRANSLATE_NOOP("problem", "The joint angle"), "°", 1, 6, Largest, Nothing,
       "The angles of the DH table.", joints_deg},
      {"device_deg", TRANSLATE_NOOP("problem", "The device's angle"), "°", 1, 6, Largest, Nothing,
       "The device's own angles: turret, thigh, shin (from the base), gimbal 1 to 3.", device_deg},
      {"branch", TRANSLATE_NOOP("problem", "The solution"), "", 0, 1, Way, Nothing,
       "Which of the eight inverse solutions the arm is on, as the panel Kinematics numbers them.", branch},
      {"solutions", TRANSLATE_NOOP("problem", "The number of inverse solutions"), "", 0, 1, Way, Nothing,
       "How many inverse solutions the pose has.", solutions},
      {"solutions_within", TRANSLATE_NOOP("problem", "The number of solutions within limits"), "", 0, 1, Way, Nothing,
       "How many of them keep every joint within its limits.", solutionsWithin},
      {"det_Jp_cm3", TRANSLATE_NOOP("problem", "The determinant of J_p"), "cm³", 1, 1, Way, Nothing,
       "The determinant of the 3x3 Jacobian.", det_cm3},
      {"manipulability_cm3", TRANSLATE_NOOP("problem", "The manipulability"), "cm³", 1, 1, Way, Nothing,
       "Its size (Yoshikawa).", manipulability_cm3},
      {"gains_mm", TRANSLATE_NOOP("problem", "The gain of J_p"), "mm", 1, 3, Way, Nothing,
       "The singular values of J_p: how far the tip goes for a radian, largest first.", gains_mm},
      {"shoulder_mm", TRANSLATE_NOOP("problem", "The distance from axis 1"), "mm", 1, 1, Way, Nothing,
       "Of the wrist centre; 0 is the shoulder singularity.", shoulder_mm},
      {"elbow_deg", TRANSLATE_NOOP("problem", "The distance from a stretched or folded elbow"), "°", 1, 1, Largest,
       Nothing, "Of q3 from 90 or -90 degrees; 0 is the elbow singularity.", elbow_deg},
      {"wrist_deg", TRANSLATE_NOOP("problem", "The distance from axes 4 and 6 in line"), "°", 1, 1, Largest, Nothing,
       "Of q5 from 0 or 180 degrees; 0 is the wrist singularity.", wrist_deg},
      {"limit_deg", TRANSLATE_NOOP("problem", "The distance to the nearest joint limit"), "°", 1, 1, Largest, Nothing,
       "The least of joints 1 to 3.", limit_deg},
      {"force_N", TRANSLATE_NOOP("problem", "The force"), "N", 2, 1, Way, Nothing,
       "The size of the force that is sent.", force_N},
      {"force_vector_N", TRANSLATE_NOOP("problem", "The force"), "N", 2, 3, Way, Nothing,
       "The force that is sent, in W.", forceVector_N},
      {"asked_N", TRANSLATE_NOOP("problem", "The force asked for"), "N", 2, 1, Way, Nothing,
       "The size of the law's force, before the limits.", asked_N},
      {"torque_N_mm", TRANSLATE_NOOP("problem", "The joint torque"), "N mm", 1, 3, Way, Nothing,
       "The torques of joints 1 to 3 that hold the force sent: J_p transposed times f.", torque_N_mm},
      {"error_mm", TRANSLATE_NOOP("problem", "The error"), "mm", 1, 1, Way, Nothing,
       "From the tip to the target, over all that act.", error_mm},
      {"offset_mm", TRANSLATE_NOOP("problem", "The way from target to tip"), "mm", 1, 3, Way, Nothing,
       "Of the first constraint that acts, in W.", offset_mm},
      {"stiffness_N_per_mm", TRANSLATE_NOOP("problem", "The stiffness felt"), "N/mm", 2, 1, Way, Nothing,
       "The force asked for over the error, from 0.2 mm on.", stiffness_N_per_mm},
      {"lean_deg", TRANSLATE_NOOP("problem", "The angle between force and way to the target"), "°", 1, 1, Largest,
       Nothing, "0: straight to the target.", lean_deg},
      {"cut_N", TRANSLATE_NOOP("problem", "What the limits take off"), "N", 2, 1, Way, Nothing,
       "Of the force asked for.", cut_N},
      {"energy_mJ", TRANSLATE_NOOP("problem", "The energy"), "mJ", 2, 1, Way, Energy,
       "What the stylus has put in and not got back; below 0 the scene is active.", energy_mJ},
      {"passive_N", TRANSLATE_NOOP("problem", "The controller's damping force"), "N", 2, 1, Way, Energy,
       "What the passivity controllers add.", passive_N},
      {"kp_N_per_mm", TRANSLATE_NOOP("problem", "The stiffness kp"), "N/mm", 2, 3, Way, Nothing,
       "Of the first constraint, along x, y, z.", kp_N_per_mm},
      {"kd_N_s_per_mm", TRANSLATE_NOOP("problem", "The damping kd"), "N s/mm", 4, 3, Way, Nothing,
       "The same of the damping; 0 where the law has none.", kd_N_s_per_mm},
      {"influence_t", TRANSLATE_NOOP("problem", "The influence t"), "", 2, 1, Way, Influence,
       "0: orientation only, 1: position only.", influence_t},
      {"influence_deg", TRANSLATE_NOOP("problem", "The angle about the shape's axis"), "°", 1, 3, Largest, Influence,
       "Of the stylus (alpha), the tip (beta) and the target (theta).", influence_deg},
      {"robot", TRANSLATE_NOOP("problem", "The virtual robot's joint"), "°", 1, 8, Largest, Robot,
       "The joints of the first virtual manipulator; those that slide in mm.", robotJoints},
      {"robot_energy_mJ", TRANSLATE_NOOP("problem", "The robot's energy"), "mJ", 2, 1, Way, Robot,
       "That its springs hold.", robotEnergy_mJ},
      {"moment_N_mm", TRANSLATE_NOOP("problem", "The moment that is not sent"), "N mm", 1, 1, Way, Robot, "Its size.",
       moment_N_mm},
      {"button", TRANSLATE_NOOP("problem", "The stylus button"), "", 0, 1, Way, Nothing, "1 while it is held.", button},
  };
  return kAll;
}

const Quantity* findQuantity(std::string_view key) {
  const std::span<const Quantity> all = quantities();
  const auto found = std::find_if(all.begin(), all.end(), [key](const Quantity& one) { return key == one.key; });
  return found == all.end() ? nullptr : &*found;
}

const char* unitOfDistance(const Quantity& quantity) {
  return quantity.apart == Apart::Turn ? "°" : quantity.unit;
}

namespace {

bool isInfluenced(const scene::Constraint& constraint) {
  return constraint.influence.has_value();
}

bool isRobot(const scene::Constraint& constraint) {
  return std::holds_alternative<scene::VirtualManipulator>(constraint.shape);
}

}  // namespace

Sentence whyMissing(const Quantity& quantity, const scene::Description& scene) {
  const auto has = [&scene](bool (*is)(const scene::Constraint&)) {
    return std::any_of(scene.constraints.begin(), scene.constraints.end(), is);
  };
  const auto missing = [&](const char* pattern) { return said(pattern, {scene.title, quantity.key}); };
  if (quantity.needs == Needs::Influence && !has(isInfluenced))
    return missing(TRANSLATE_NOOP("problem", "The scene \"%1\" has no %2: no constraint of it has an influence."));
  if (quantity.needs == Needs::Robot && !has(isRobot))
    return missing(
        TRANSLATE_NOOP("problem", "The scene \"%1\" has no %2: no constraint of it is a virtual manipulator."));
  if (quantity.needs != Needs::Energy) return {};
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    if (scene::controlOf(scene, index).passivity != control::Passivity::Off) return {};
  }
  return missing(
      TRANSLATE_NOOP("problem", "The scene \"%1\" has no %2: nobody counts its energy, since passivity is \"off\"."));
}

}  // namespace underact::lesson
