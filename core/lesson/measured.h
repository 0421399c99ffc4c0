#pragma once
#include "core/lesson/quantity.h"

namespace underact::lesson {

// Inside the room: how each quantity of the catalogue comes out of a tick.

Values tip_mm(const Seen& seen);
Values tipInBase_mm(const Seen& seen);
Values velocity_mm_per_s(const Seen& seen);
Values speed_mm_per_s(const Seen& seen);
Values stylus(const Seen& seen);
Values joints_deg(const Seen& seen);
Values device_deg(const Seen& seen);
Values branch(const Seen& seen);
Values solutions(const Seen& seen);
Values solutionsWithin(const Seen& seen);
Values det_cm3(const Seen& seen);
Values manipulability_cm3(const Seen& seen);
Values gains_mm(const Seen& seen);
Values shoulder_mm(const Seen& seen);
Values elbow_deg(const Seen& seen);
Values wrist_deg(const Seen& seen);
Values limit_deg(const Seen& seen);
Values force_N(const Seen& seen);
Values forceVector_N(const Seen& seen);
Values asked_N(const Seen& seen);
Values torque_N_mm(const Seen& seen);
Values error_mm(const Seen& seen);
Values offset_mm(const Seen& seen);
Values stiffness_N_per_mm(const Seen& seen);
Values lean_deg(const Seen& seen);
Values cut_N(const Seen& seen);
Values energy_mJ(const Seen& seen);
Values passive_N(const Seen& seen);
Values kp_N_per_mm(const Seen& seen);
Values kd_N_s_per_mm(const Seen& seen);
Values influence_t(const Seen& seen);
Values influence_deg(const Seen& seen);
Values robotJoints(const Seen& seen);
Values robotEnergy_mJ(const Seen& seen);
Values moment_N_mm(const Seen& seen);
Values button(const Seen& seen);

}  // namespace underact::lesson
