#pragma once
#include <cstdint>

#include "core/arm/preset.h"
#include "core/arm/sample.h"
#include "core/base/integration.h"
#include "core/base/real_time.h"
#include "core/sim/arm_model.h"
#include "core/sim/hand.h"

namespace underact::sim {

/// The simulated arm and the hand that holds it: parameters.
struct Plant {
  arm::Preset arm;
  ArmModel model;
  HandModel hand;
  Integration integration = {};
};

/// The plant with the model's encoders, where it has its own, and the mass of modelFor().
Plant makePlant(const arm::Preset& arm, const ArmModel& model, const HandModel& hand,
                const Integration& integration = {});

/// The state of a plant.
struct PlantState {
  Vec3 p_WT = Vec3::Zero();  // m
  Vec3 v_WT = Vec3::Zero();  // m/s
  arm::JointAngles q_rad{};  // exact joints for p_WT, and the wrist
  arm::JointAngles dq{};     // rad/s or m/s, of an arm that moves in its joints
};

/// At rest at p_WT, finite (brought inside reach and joint limits), the wrist in the middle of its gimbal. An arm that
/// does not solvesInTick(): as near as a search from its rest comes, of 200 steps at most.
PlantState restingState(const Plant& plant, const Vec3& p_WT) noexcept;
/// At rest where the arm is when nobody has moved it: at its rest, or with the tip 60 mm before the origin of W.
PlantState restingState(const Plant& plant) noexcept;

/// The state after period_ns under the arm's force f_T_W and, of an arm that renders one, its moment m_T_W (both held
/// over the period) and the hand's wish, in substeps as
/// plant.integration says; with the mean velocity a force is neither early nor late. The dampers, the hand's spring and
/// the Coulomb friction are implicit, so that sticking does not chatter at any step size. wish: at the end of the
/// period; until then it moves uniformly at its v_WT. Where the reach or a joint limit stops the motion, the tip stays
/// at the limit and keeps only the velocity along it. A force that is not finite counts as none, a setpoint that is not
/// finite as one to stay. Within reach exact to 4 ulp of displacement and speed for each substep in free motion, and to
/// 64 ulp of all impulses otherwise. An arm that does not solvesInTick() moves in its joints (mechanics.h). Finite
/// in, finite out; deterministic to the bit. Cost: linear in period_ns.
PlantState advance(const Plant& plant, PlantState state, const Vec3& f_T_W, const HandSetpoint& setpoint,
                   std::int64_t period_ns, const Vec3& m_T_W = Vec3::Zero()) noexcept UNDERACT_REAL_TIME;

/// The joints as the encoders show them; exact where a joint has none. Of an arm that solvesInTick() they measure
/// turret, thigh and shin, and the gimbal.
arm::JointAngles quantized(const arm::Preset& arm, const arm::JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

/// The joints as the plant shows them: through its encoders, or exact where it has none.
arm::JointAngles shownAngles(const Plant& plant, const PlantState& state) noexcept UNDERACT_REAL_TIME;

/// The joints after one step of that joint's encoder; as they are where it has none. The Omni's thigh is measured apart
/// from its shin, so a step of one changes two angles of the table.
arm::JointAngles afterEncoderStep(const arm::Preset& arm, const arm::JointAngles& q_rad, std::size_t joint) noexcept;

}  // namespace underact::sim
