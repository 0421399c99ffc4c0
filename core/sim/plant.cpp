#include "core/sim/plant.h"

#include <algorithm>
#include <cmath>

#include "core/arm/mechanism.h"
#include "core/base/units.h"
#include "core/sim/mechanics.h"

namespace underact::sim {
namespace {

template <class Numbers>
bool areFinite(const Numbers& numbers) noexcept UNDERACT_REAL_TIME {
  return std::all_of(numbers.data(), numbers.data() + numbers.size(), [](double x) { return std::isfinite(x); });
}

const Mechanics& mechanicsOf(const arm::Geometry& geometry) noexcept UNDERACT_REAL_TIME {
  if (arm::solvesInTick(geometry)) return kTipMechanics;
  return arm::jointsOf(geometry) <= 6 ? kSixJointMechanics : kJointMechanics;
}

/// The step of a joint's encoder, rad, or m where it slides; infinite where it has none.
double encoderStep(const arm::Preset& arm, std::size_t joint) noexcept UNDERACT_REAL_TIME {
  const double counts = arm.counts_per_turn[joint];
  if (!(counts > 0.0)) return kInfinity;
  return (arm::slides(arm.geometry, joint) ? kMetrePerMillimetre : 2.0 * kPi) / counts;
}

}  // namespace

bool isFinite(const PlantState& state) noexcept {
  return areFinite(state.p_WT) && areFinite(state.v_WT) && areFinite(state.dq);
}

Plant makePlant(const arm::Preset& arm, const ArmModel& model, const HandModel& hand, const Integration& integration) {
  Plant plant{arm, modelFor(arm, model), hand, integration};
  if (model.counts_per_turn) plant.arm.counts_per_turn = countsOf(*model.counts_per_turn, arm.counts_per_turn);
  return plant;
}

PlantState restingState(const Plant& plant) noexcept {
  return mechanicsOf(plant.arm.geometry).restAt(plant, nullptr);
}

PlantState restingState(const Plant& plant, const Vec3& p_WT) noexcept {
  return mechanicsOf(plant.arm.geometry).restAt(plant, &p_WT);
}

PlantState advance(const Plant& plant, PlantState state, const Vec3& f_T_W, const HandSetpoint& setpoint,
                   std::int64_t period_ns, const Vec3& m_T_W) noexcept {
  HandSetpoint wish = setpoint;
  if (!areFinite(wish.p_WT) || !areFinite(wish.v_WT)) wish.p_WT = state.p_WT, wish.v_WT.setZero();
  wish.turns = wish.turns && areFinite(wish.R_WT);
  const Pushed pushed{areFinite(f_T_W) ? f_T_W : Vec3::Zero(), areFinite(m_T_W) ? m_T_W : Vec3::Zero()};
  const PlantState next = mechanicsOf(plant.arm.geometry).advance(plant, state, pushed, wish, period_ns);
  if (isFinite(next)) return next;
  state.v_WT.setZero();  // an overflow
  state.dq = {};
  return state;
}

arm::JointAngles quantized(const arm::Preset& arm, const arm::JointAngles& q_rad) noexcept {
  const Mechanics& mechanics = mechanicsOf(arm.geometry);
  arm::JointAngles measured = mechanics.measuredOf(q_rad);
  for (std::size_t joint = 0; joint < measured.size(); ++joint) {
    const double step = encoderStep(arm, joint);
    if (std::isfinite(step)) measured[joint] = step * std::round(measured[joint] / step);
  }
  return mechanics.jointsOf(measured);
}

arm::JointAngles shownAngles(const Plant& plant, const PlantState& state) noexcept {
  return plant.model.encoders ? quantized(plant.arm, state.q_rad) : state.q_rad;
}

arm::JointAngles afterEncoderStep(const arm::Preset& arm, const arm::JointAngles& q_rad, std::size_t joint) noexcept {
  const double step = encoderStep(arm, joint);
  if (!std::isfinite(step)) return q_rad;
  const Mechanics& mechanics = mechanicsOf(arm.geometry);
  arm::JointAngles measured = mechanics.measuredOf(q_rad);
  measured[joint] += step;
  return mechanics.jointsOf(measured);
}

}  // namespace underact::sim
